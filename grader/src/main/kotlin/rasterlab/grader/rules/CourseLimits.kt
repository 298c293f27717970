package rasterlab.grader.rules

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.limits.IntakeLimits
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** Names the limits that an instructor may set, as in the HTTP API. */
enum class LimitField(
    val code: String,
) {
    PER_MINUTE("submissionsPerMinute"),
    WAITING("waiting"),
}

/**
 * Limits that hold in a course.
 *
 * @param own what was set there; null for what the server allows
 */
data class CourseLimit(
    val limits: IntakeLimits,
    val own: Map<LimitField, Int?>,
)

/**
 * Keeps how much one student of a course may hand in, which is never more than the server allows.
 *
 * @param most what the server allows
 */
class CourseLimits(
    private val database: Database,
    val most: IntakeLimits,
    private val clock: InstantSource,
) {
    fun of(course: Course): CourseLimit = database.read { of(it, course) }

    /**
     * Changes the limits of a course, from the next submission on.
     *
     * @param told numbers as somebody wrote them, empty for what the server allows; what is not told stays as it is
     * @param by who does it, for the audit
     * @throws Rejection.BadRule that names the field, what it is, and what is allowed
     */
    fun change(
        course: Course,
        told: Map<LimitField, String>,
        by: String,
    ): CourseLimit =
        database.write { handle ->
            val before = of(handle, course).own
            val after = before + told.mapValues { (field, text) -> number(field, text) }
            if (after != before) {
                store(handle, course, after)
                val detail = after.entries.joinToString { "${it.key.code} ${it.value ?: "–"}" }
                AuditNote(by, course.id, "limits", course.id, detail).write(handle, clock.instant())
            }
            of(handle, course)
        }

    private fun of(
        handle: Handle,
        course: Course,
    ): CourseLimit {
        val own = own(handle, "SELECT per_minute, waiting FROM course_limits WHERE course_id = :id", course.id)
        return CourseLimit(limits(own, most), own)
    }

    private fun number(
        field: LimitField,
        text: String,
    ): Int? {
        if (text.isBlank()) return null
        val allowed = 1..(if (field == LimitField.WAITING) most.waiting else most.perMinute)
        return text.trim().toIntOrNull()?.takeIf { it in allowed }
            ?: throw Rejection.BadRule("limit", field.code, text, allowed.first, allowed.last)
    }

    companion object {
        /** Reads what holds for a student, within the transaction of [handle]. */
        internal fun of(
            handle: Handle,
            student: String,
            most: IntakeLimits,
        ): IntakeLimits = limits(own(handle, OF_STUDENT, student), most)

        /** Gives a course the limits of another, within a transaction. */
        internal fun copy(
            handle: Handle,
            from: Course,
            to: Course,
        ) {
            handle
                .createUpdate(
                    """INSERT INTO course_limits (course_id, per_minute, waiting)
                       SELECT :to, per_minute, waiting FROM course_limits WHERE course_id = :from""",
                ).bind("from", from.id)
                .bind("to", to.id)
                .execute()
        }

        private const val OF_STUDENT =
            """SELECT per_minute, waiting
               FROM course_limits JOIN students ON students.course_id = course_limits.course_id WHERE students.id = :id"""

        private fun own(
            handle: Handle,
            query: String,
            id: String,
        ): Map<LimitField, Int?> =
            handle
                .createQuery(query)
                .bind("id", id)
                .map { row, _ ->
                    val columns = mapOf(LimitField.PER_MINUTE to "per_minute", LimitField.WAITING to "waiting")
                    columns.mapValues { (_, column) -> (row.getObject(column) as Number?)?.toInt() }
                }.findOne()
                .getOrNull() ?: LimitField.entries.associateWith { null }

        private fun limits(
            own: Map<LimitField, Int?>,
            most: IntakeLimits,
        ) = IntakeLimits(
            own[LimitField.WAITING] ?: most.waiting,
            own[LimitField.PER_MINUTE] ?: most.perMinute,
        ).atMost(most)

        private fun store(
            handle: Handle,
            course: Course,
            own: Map<LimitField, Int?>,
        ) {
            handle.execute("DELETE FROM course_limits WHERE course_id = ?", course.id)
            handle
                .createUpdate(
                    "INSERT INTO course_limits (course_id, per_minute, waiting) VALUES (:id, :minute, :waiting)",
                ).bind("id", course.id)
                .bind("minute", own[LimitField.PER_MINUTE])
                .bind("waiting", own[LimitField.WAITING])
                .execute()
        }
    }
}
