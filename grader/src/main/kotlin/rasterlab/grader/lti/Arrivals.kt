package rasterlab.grader.lti

import kotlinx.serialization.json.Json
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.OnceOnly
import java.time.InstantSource

/** The next step for somebody whom a platform has sent. */
sealed interface LaunchStep {
    val launch: Launch

    /** Somebody who teaches there has to say who of the staff they are here. */
    class WhoAreYou(
        override val launch: Launch,
    ) : LaunchStep

    /** An instructor has to say which course here the platform's course is. */
    class WhichCourse(
        override val launch: Launch,
        val courses: List<Course>,
    ) : LaunchStep

    /** Staff choose exercises of the course that are to stand at the platform as links. */
    class WhichExercises(
        override val launch: Launch,
        val course: Course,
        val wish: LinkWish,
    ) : LaunchStep

    /** The person is let in, to a page. */
    class LetIn(
        override val launch: Launch,
        val who: Identity,
        val course: String,
        val page: String,
    ) : LaunchStep
}

/** Leads whom a platform has sent to where they wanted, asking what is not known yet. */
class Arrivals(
    database: Database,
    private val accounts: Accounts,
    private val courses: Courses,
    private val exercises: Exercises,
    private val bindings: Bindings,
    private val platforms: Platforms,
    clock: InstantSource,
) {
    private val kept = OnceOnly(database, clock, "lti-launch")

    /** Keeps a launch that a question has interrupted, under the key that it returns. */
    fun keep(launch: Launch): String = kept.keep(Json.encodeToString(launch))

    /**
     * Gives out, once, the launch that goes on.
     *
     * @throws LtiRefused
     */
    fun take(key: String?): Launch = Json.decodeFromString(key?.let(kept::take) ?: throw LtiRefused(LtiFault.STALE))

    /**
     * Goes as far as it can without asking.
     *
     * @throws LtiRefused
     */
    fun next(launch: Launch): LaunchStep =
        if (launch.role == LaunchRole.LEARNER) {
            val course = bindings.courseOf(launch) ?: throw LtiRefused(LtiFault.UNBOUND)
            entered(launch, known(bindings.student(launch, course)), course)
        } else {
            forStaff(launch)
        }

    /**
     * Tells who somebody of the staff is, by their token.
     *
     * @throws LtiRefused
     */
    fun tell(
        launch: Launch,
        token: String,
    ) {
        val who = accounts.holder(token.trim()) as? Identity.StaffIdentity ?: throw LtiRefused(LtiFault.TOKEN)
        bindings.link(launch, who.id)
    }

    /**
     * Tells which course here the platform's course is.
     *
     * @param course id of a course; empty for a new one of that [name]
     * @throws LtiRefused where the person is no instructor here
     */
    fun bind(
        launch: Launch,
        course: String,
        name: String,
    ) {
        val who = bindings.staffOf(launch)?.let(::known) as? Identity.Instructor ?: throw LtiRefused(LtiFault.UNBOUND)
        val meant =
            if (who.onlyCourse != null) {
                courses.find(course)?.takeIf { who.teaches(it.id) } ?: throw Rejection.UnknownCourse(course)
            } else if (course.isEmpty()) {
                courses.create(who.id, Name.of(name), key = null)
            } else {
                courses.find(course) ?: throw Rejection.UnknownCourse(course)
            }
        bindings.bind(launch, meant, who.id)
    }

    private fun forStaff(launch: Launch): LaunchStep {
        val platform = platforms.find(launch.platform) ?: throw LtiRefused(LtiFault.UNKNOWN_PLATFORM)
        val account =
            bindings.staffOf(launch)
                ?: if (platform.makesStaff) bindings.makeStaff(launch) else return LaunchStep.WhoAreYou(launch)
        val who = known(account)
        val course = bindings.courseOf(launch)
        if (course != null && who is Identity.StaffIdentity && !who.teaches(course.id)) {
            throw LtiRefused(LtiFault.OTHER_COURSE, "account $account does not teach course ${course.id}")
        }
        return when {
            course != null && launch.wish != null -> LaunchStep.WhichExercises(launch, course, launch.wish)
            course != null -> entered(launch, who, course)
            who is Identity.Instructor -> LaunchStep.WhichCourse(launch, courses.of(who))
            else -> throw LtiRefused(LtiFault.UNBOUND)
        }
    }

    private fun entered(
        launch: Launch,
        who: Identity,
        course: Course,
    ): LaunchStep {
        val exercise = launch.exercise?.let(exercises::find)
        if (exercise != null) bindings.keepLink(launch, exercise.id())
        val page =
            when {
                exercise != null -> "/exercises/${exercise.id()}"
                who is Identity.StudentIdentity -> "/exercises"
                else -> "/instructor"
            }
        return LaunchStep.LetIn(launch, who, course.name, page)
    }

    private fun known(account: String): Identity =
        accounts.withId(account) ?: throw LtiRefused(LtiFault.REVOKED, "account $account")
}
