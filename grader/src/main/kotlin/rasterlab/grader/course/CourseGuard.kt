package rasterlab.grader.course

import io.ktor.http.HttpMethod
import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.server.request.httpMethod
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import kotlin.jvm.optionals.getOrNull

/**
 * Keeps who teaches a single course from other courses and from what belongs to the whole server, whatever the address.
 * An address passes only where it is known to be of that course or for everybody, so that a new one is closed to them at
 * first, but for what lies below an exercise.
 */
class CourseGuard(
    private val accounts: Accounts,
    private val database: Database,
) {
    /** @throws Rejection of a thing that is not there for who calls, or of the role */
    fun pass(call: ApplicationCall) {
        val parts = call.addressParts()
        if (parts.firstOrNull() in FREE) return
        for (who in accounts.callers(call).filterIsInstance<Identity.StaffIdentity>()) {
            who.onlyCourse?.let { requireOpen(it, call.request.httpMethod, parts) }
        }
    }

    private fun requireOpen(
        course: String,
        method: HttpMethod,
        parts: List<String>,
    ) {
        val place = if (parts.take(API.size) == API) parts.drop(API.size) else parts
        if (isForAll(place) || (method == HttpMethod.Get && place == COURSES)) return
        val within = if (place.first() == DESK) place.drop(1) else place
        val known = KINDS[within.firstOrNull()]
        val id = within.getOrNull(1)
        if (known == null || id == null || within.drop(2) == CLONE) throw Rejection.WrongRole("staff of all courses")
        val found =
            database.read {
                it
                    .createQuery(known.course)
                    .bind("id", id)
                    .mapTo(String::class.java)
                    .findOne()
            }
        if (found.getOrNull() != course) throw known.missing(id)
    }

    private fun isForAll(place: List<String>): Boolean =
        place.isEmpty() ||
            place in OWN ||
            (place.first() == "exercises" && ACROSS.none { it in place.drop(2) })

    /**
     * A thing that an address names.
     *
     * @param course selects the id of its course
     */
    private class Kind(
        val course: String,
        val missing: (String) -> Rejection,
    )

    private companion object {
        val API = listOf("api", "v1")
        const val DESK = "instructor"

        /** Beginnings of what is for everybody, or lets somebody in or out. */
        val FREE = setOf("assets", "sign-in", "sign-out", "join", "lti", "healthz", "readyz", "metrics", "openapi.json")

        /** Addresses that show each of the staff what is theirs. */
        val OWN =
            setOf(
                listOf(DESK),
                listOf(DESK, "latest"),
                listOf(DESK, "events"),
                listOf(DESK, "view", "end"),
                listOf("join"),
            )

        /** The address that lists to each of the staff the courses that they teach, and makes new ones. */
        val COURSES = listOf("courses")

        /** Parts of an exercise's addresses that show the work of all courses. */
        val ACROSS = setOf("similarity", "programs.zip")

        /** The course that comes of it belongs to nobody of a single one. */
        val CLONE = listOf("clone")

        private const val OF_STUDENT = "SELECT course_id FROM students WHERE id ="

        val KINDS =
            mapOf(
                "courses" to
                    Kind("SELECT id FROM courses WHERE id = :id OR code = upper(trim(:id))", Rejection::UnknownCourse),
                "students" to Kind("$OF_STUDENT :id", Rejection::UnknownStudent),
                "submissions" to
                    Kind(
                        "$OF_STUDENT (SELECT student_id FROM submissions WHERE id = :id)",
                        Rejection::UnknownSubmission,
                    ),
                "trials" to
                    Kind(
                        """$OF_STUDENT (SELECT student_id FROM submissions
                           WHERE id = (SELECT submission_id FROM trials WHERE id = :id))""",
                        Rejection::UnknownTrial,
                    ),
                "exams" to Kind("SELECT course_id FROM exams WHERE id = :id", Rejection::UnknownExam),
                "regrades" to Kind("SELECT course_id FROM regrades WHERE id = :id", Rejection::UnknownRegrade),
            )
    }
}

/** Has [guard] look at each call before it is handled. */
fun Application.guardCourses(guard: CourseGuard) = intercept(ApplicationCallPipeline.Plugins) { guard.pass(call) }
