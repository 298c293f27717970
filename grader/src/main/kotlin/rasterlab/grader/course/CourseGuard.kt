package rasterlab.grader.course

import io.ktor.http.HttpMethod
import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.server.request.httpMethod
import io.ktor.server.routing.RoutingRoot
import io.ktor.util.AttributeKey
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database

/**
 * Keeps who teaches a single course from other courses and from what belongs to the whole server, whatever the address.
 * An address passes only where it is known to be of that course or for everybody, so that a new one is closed to them at
 * first, but for what lies below an exercise.
 */
class CourseGuard(
    private val accounts: Accounts,
    database: Database,
) {
    private val addressed = AddressedCourse(database)

    /**
     * Lets a call through that may go on; one that may not is refused where the address turns out to be served, so that
     * nobody is told of a role that an address would need which there is not.
     *
     * @throws Rejection of a thing that is not there for who calls
     */
    fun pass(call: ApplicationCall) {
        val parts = call.addressParts()
        if (parts.firstOrNull() in FREE) return
        for (who in accounts.callers(call).filterIsInstance<Identity.StaffIdentity>()) {
            who.onlyCourse?.let { requireOpen(it, call, parts) }
        }
    }

    private fun requireOpen(
        course: String,
        call: ApplicationCall,
        parts: List<String>,
    ) {
        val place = AddressedCourse.withoutApi(parts)
        if (isForAll(place) || (call.request.httpMethod == HttpMethod.Get && place == COURSES)) return
        val named = addressed.of(parts)
        if (named == null || AddressedCourse.within(parts).drop(2) == CLONE) {
            return call.attributes.put(CLOSED, Rejection.WrongRole("staff of all courses"))
        }
        if (named.course != course) throw named.missing
    }

    private fun isForAll(place: List<String>): Boolean =
        place.isEmpty() ||
            place in OWN ||
            (place.first() == "exercises" && ACROSS.none { it in place.drop(2) })

    private companion object {
        /** Beginnings of what is for everybody, or lets somebody in or out. */
        val FREE = setOf("assets", "sign-in", "sign-out", "join", "lti", "healthz", "readyz", "metrics", "openapi.json")

        /** Addresses that show each of the staff what is theirs. */
        val OWN =
            setOf(
                listOf(AddressedCourse.DESK),
                listOf(AddressedCourse.DESK, "latest"),
                listOf(AddressedCourse.DESK, "events"),
                listOf(AddressedCourse.DESK, "view", "end"),
                listOf("join"),
            )

        /** The address that lists to each of the staff the courses that they teach, and makes new ones. */
        val COURSES = listOf("courses")

        /** Parts of an exercise's addresses that show the work of all courses. */
        val ACROSS = setOf("similarity", "programs.zip")

        /** The course that comes of it belongs to nobody of a single one. */
        val CLONE = listOf("clone")
    }
}

/** Why a call is refused where its address is served. */
private val CLOSED = AttributeKey<Rejection>("why the address is closed to who calls")

/** Has [guard] look at each call before it is handled. */
fun Application.guardCourses(guard: CourseGuard) {
    intercept(ApplicationCallPipeline.Plugins) { guard.pass(call) }
    monitor.subscribe(RoutingRoot.RoutingCallStarted) { call -> call.attributes.getOrNull(CLOSED)?.let { throw it } }
}
