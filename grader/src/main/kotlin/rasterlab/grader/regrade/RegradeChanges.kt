package rasterlab.grader.regrade

import org.jdbi.v3.core.Handle
import rasterlab.grader.submission.Submissions
import java.sql.ResultSet

/**
 * The verdict and the points of one result.
 *
 * @param points less what hints and lateness cost
 */
data class RegradePoints(
    val verdict: String,
    val points: Int,
    val of: Int,
)

/**
 * A case whose verdict or points are not what they were.
 *
 * @param before its verdict and points, null where it is new
 * @param after the same now, null where it is gone
 */
class CaseChange(
    val name: String,
    val before: Pair<String, Int>?,
    val after: Pair<String, Int>?,
)

/**
 * One submission of a regrade.
 *
 * @param after null where it is not graded, or by a fault of ours has no result
 */
class RegradeChange(
    val submission: String,
    val student: String,
    val name: String,
    val attempt: Int,
    val before: RegradePoints,
    val after: RegradePoints?,
    val cases: List<CaseChange>,
) {
    /** Points that are gained; negative where they are lost. */
    val gain get() = if (after == null) 0 else after.points - before.points
}

/** Compares results of a regrade with those of before: the ones that it replaced, or that count while it has not. */
internal class RegradeChanges(
    private val handle: Handle,
    private val regrade: Regrade,
) {
    /** All submissions of the regrade, those that lose most first. */
    fun all(): List<RegradeChange> {
        val cases = cases()
        return handle
            .createQuery(
                """SELECT s.id, s.student_id, students.shown_name, s.attempt,
                       b.verdict AS old_verdict, ${Submissions.graded("b")} AS old_points, b.points_of AS old_of,
                       a.verdict AS new_verdict, ${Submissions.graded("a")} AS new_points, a.points_of AS new_of
                   FROM regrade_items i
                   JOIN submissions s ON s.id = i.submission_id
                   JOIN students ON students.id = s.student_id
                   JOIN results b ON b.id = $BEFORE
                   LEFT JOIN results a ON a.id = i.result_id AND a.verdict <> 'internal'
                   WHERE i.regrade_id = :regrade ORDER BY i.position""",
            ).bind("regrade", regrade.id)
            .map { row, _ ->
                val id = row.getString("id")
                val after = points(row, "new")
                RegradeChange(
                    id,
                    row.getString("student_id"),
                    row.getString("shown_name"),
                    row.getInt("attempt"),
                    checkNotNull(points(row, "old")),
                    after,
                    if (after == null) emptyList() else cases[id].orEmpty(),
                )
            }.list()
            .sortedBy { it.gain }
    }

    private fun points(
        row: ResultSet,
        which: String,
    ) = row.getString("${which}_verdict")?.let {
        RegradePoints(it, row.getInt("${which}_points"), row.getInt("${which}_of"))
    }

    private fun cases(): Map<String, List<CaseChange>> =
        handle
            .createQuery(
                """SELECT i.submission_id, a.position, a.name, b.verdict AS old_verdict, b.points AS old_points,
                       a.verdict AS new_verdict, a.points AS new_points
                   FROM regrade_items i JOIN case_results a ON a.result_id = i.result_id
                   LEFT JOIN case_results b ON b.result_id = $BEFORE AND b.name = a.name
                   WHERE i.regrade_id = :regrade AND (b.name IS NULL OR a.verdict <> b.verdict OR a.points <> b.points)
                   UNION ALL
                   SELECT i.submission_id, b.position, b.name, b.verdict, b.points, NULL, 0
                   FROM regrade_items i JOIN case_results b ON b.result_id = $BEFORE
                   WHERE i.regrade_id = :regrade AND NOT EXISTS
                       (SELECT 1 FROM case_results a WHERE a.result_id = i.result_id AND a.name = b.name)
                   ORDER BY 1, 2""",
            ).bind("regrade", regrade.id)
            .map { row, _ ->
                fun state(which: String) =
                    row.getString("${which}_verdict")?.let { it.lowercase() to row.getInt("${which}_points") }
                row.getString("submission_id") to CaseChange(row.getString("name"), state("old"), state("new"))
            }.list()
            .groupBy({ it.first }, { it.second })

    private companion object {
        const val BEFORE =
            """coalesce(i.former_id,
               (SELECT id FROM results r WHERE r.submission_id = i.submission_id AND r.is_current = 1))"""
    }
}
