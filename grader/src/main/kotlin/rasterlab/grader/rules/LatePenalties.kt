package rasterlab.grader.rules

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.Course
import java.time.Instant

/**
 * Keeps what late submissions cost in step with the rules. None costs more than its student agreed to when it came; a later
 * deadline, or a milder rule, makes it cheaper.
 */
internal object LatePenalties {
    /** Settles the submissions of an exercise that cost something when they came, after its rules or a deadline changed. */
    fun settle(
        handle: Handle,
        course: Course,
        exercise: String,
    ) {
        val costs =
            handle
                .createQuery(
                    """SELECT s.id, s.received_at, s.penalty_agreed, s.due_at AS due_then, ${ExerciseRules.COLUMNS}
                       FROM submissions s JOIN students ON students.id = s.student_id
                       LEFT JOIN course_exercises AS rules
                           ON rules.course_id = students.course_id AND rules.exercise = s.exercise
                       LEFT JOIN extensions ON extensions.student_id = s.student_id AND extensions.exercise = s.exercise
                       WHERE students.course_id = :course AND s.exercise = :exercise AND s.penalty_agreed > 0""",
                ).bind("course", course.id)
                .bind("exercise", exercise)
                .map { row, _ ->
                    val rules = ExerciseRules.of(row).orDue(row.getString("due_then")?.let(Instant::parse))
                    val now = rules.penalty(Instant.parse(row.getString("received_at")))
                    row.getString("id") to minOf(row.getInt("penalty_agreed"), now)
                }.list()
        val update = handle.prepareBatch("UPDATE submissions SET penalty = :penalty WHERE id = :id")
        costs.forEach { (id, penalty) -> update.bind("id", id).bind("penalty", penalty).add() }
        if (costs.isNotEmpty()) update.execute()
    }
}
