package rasterlab.grader.rules

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Name
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import java.time.Instant
import java.time.InstantSource
import java.time.ZoneId

/**
 * Makes this year's course of last year's: the same rules, later, and nobody in it.
 *
 * @param copyToo gives the second course what else the first one has, within the transaction
 */
class CourseClones(
    private val database: Database,
    private val clock: InstantSource,
    private val copyToo: (Handle, Course, Course) -> Unit,
) {
    /**
     * Makes a course with the rules of another, whose moments are moved by whole days and keep their time of day.
     *
     * @param days as somebody wrote them
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it makes no other course
     */
    fun clone(
        from: Course,
        name: Name,
        days: String,
        by: String,
        key: String?,
    ): Course {
        val shift =
            days.trim().toIntOrNull()?.takeIf { it in ALLOWED }
                ?: throw Rejection.BadRule("days", "days", days, ALLOWED.first, ALLOWED.last)
        val request = Repeatable("clone $by", key, "${from.id} ${name.text} $shift")
        return database.write { handle ->
            request.made(handle)?.let { Courses.course(handle, "id", it) } ?: run {
                val made = Courses.insert(handle, name, clock.instant())
                for ((exercise, rules) in CourseRules.ofCourse(handle, from)) {
                    CourseRules.store(handle, made, exercise, rules.movedBy(shift))
                }
                CourseExercises.copy(handle, from, made)
                CourseLimits.copy(handle, from, made)
                copyToo(handle, from, made)
                AuditNote(by, made.id, "clone", from.id, "$shift days").write(handle, clock.instant())
                request.remember(handle, made.id, clock.instant())
                made
            }
        }
    }

    private fun ExerciseRules.movedBy(days: Int) =
        copy(opens = opens?.movedBy(days, zone), due = due?.movedBy(days, zone))

    private fun Instant.movedBy(
        days: Int,
        zone: ZoneId,
    ) = atZone(zone).plusDays(days.toLong()).toInstant()

    companion object {
        /** Whole weeks keep the days of the week. */
        const val YEAR_OF_WEEKS = 364

        private val ALLOWED = -3_660..3_660
    }
}
