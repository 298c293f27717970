package rasterlab.grader.submission

import rasterlab.grader.storage.Database
import java.time.Duration
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
                        """SELECT s.student_id, s.exercise, s.received_at, s.is_chosen, rules.policy, rules.late_days,
                               coalesce(extensions.due_at, rules.due_at) AS due_at, ${Submissions.NET} AS points
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
                            row.getString("policy") ?: "best",
                            row.getString("due_at")?.let(Instant::parse),
                            row.getInt("late_days").takeUnless { row.wasNull() },
                        )
                    }.list()
            }.filter { it.counts() }
            .groupBy { it.student }
            .mapValues { (_, all) -> all.groupBy { it.exercise }.mapValues { points(it.value) } }

    /** @param inOrder of arrival, at least one */
    private fun points(inOrder: List<Handed>): Int {
        val best = inOrder.maxOf { it.points }
        return when (inOrder.last().policy) {
            "last" -> inOrder.last().points
            "chosen" -> inOrder.lastOrNull { it.chosen }?.points ?: best
            else -> best
        }
    }

    private class Handed(
        val student: String,
        val exercise: String,
        val receivedAt: Instant,
        val points: Int,
        val chosen: Boolean,
        val policy: String,
        val due: Instant?,
        val lateDays: Int?,
    ) {
        /** Whether it counts: later than the last late day, it was practice. */
        fun counts() = due == null || lateDays == null || receivedAt <= due + Duration.ofDays(lateDays.toLong())
    }
}
