package rasterlab.grader.submission

import rasterlab.grader.rules.Arrival
import rasterlab.grader.rules.CountingPolicy
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.storage.Database
import java.time.Instant

/** The points that count of what students handed in, by the rules of their course. */
class Marks(
    private val database: Database,
) {
    /** Finds them by student, and then by exercise; nothing where nothing that counts is graded yet. */
    fun of(course: String): Map<String, Map<String, Int>> =
        database
            .read { handle ->
                handle
                    .createQuery(
                        """SELECT s.student_id, s.exercise, s.received_at, s.is_chosen, s.due_at AS due_then,
                               ${ExerciseRules.COLUMNS}, ${Submissions.NET} AS points
                           FROM submissions s
                           JOIN students ON students.id = s.student_id
                           JOIN results r ON r.submission_id = s.id AND r.is_current = 1
                           LEFT JOIN course_exercises AS rules
                               ON rules.course_id = students.course_id AND rules.exercise = s.exercise
                           LEFT JOIN extensions ON extensions.student_id = s.student_id AND extensions.exercise = s.exercise
                           WHERE students.course_id = :course ORDER BY s.sequence""",
                    ).bind("course", course)
                    .map { row, _ ->
                        Handed(
                            row.getString("student_id"),
                            row.getString("exercise"),
                            Instant.parse(row.getString("received_at")),
                            row.getInt("points"),
                            row.getInt("is_chosen") == 1,
                            ExerciseRules.of(row).orDue(row.getString("due_then")?.let(Instant::parse)),
                        )
                    }.list()
            }.filter { it.counts() }
            .groupBy { it.student }
            .mapValues { (_, all) -> all.groupBy { it.exercise }.mapValues { points(it.value) } }

    /** @param inOrder of arrival, at least one */
    private fun points(inOrder: List<Handed>): Int {
        val best = inOrder.maxOf { it.points }
        return when (inOrder.last().rules.policy) {
            CountingPolicy.BEST -> best
            CountingPolicy.LAST -> inOrder.last().points
            CountingPolicy.CHOSEN -> inOrder.lastOrNull { it.chosen }?.points ?: best
        }
    }

    private class Handed(
        val student: String,
        val exercise: String,
        val receivedAt: Instant,
        val points: Int,
        val chosen: Boolean,
        val rules: ExerciseRules,
    ) {
        fun counts() = rules.arrival(receivedAt) != Arrival.PRACTICE
    }
}
