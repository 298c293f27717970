package rasterlab.grader.classroom

import org.jdbi.v3.core.Handle
import org.jdbi.v3.core.statement.Query
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.grader.submission.hash
import java.sql.ResultSet

/** The cases of a result, and the mistake that explains all that is wrong; nothing where it tells none. */
internal class ResultMarks(
    val cases: List<CaseMark>,
    val shared: Message,
)

/**
 * Reads what results say of their cases, each once: but for the speed, which is not told here, nothing of a result ever
 * changes. A class of 200 has thousands of cases and pictures, which are read again for no new look at its page.
 */
internal class KnownMarks {
    private val known =
        object : LinkedHashMap<String, ResultMarks>(16, 0.75f, true) {
            override fun removeEldestEntry(eldest: Map.Entry<String, ResultMarks>) = size > MOST
        }

    /** @param results their ids, of those that are recorded */
    fun of(
        handle: Handle,
        results: List<String>,
    ): Map<String, ResultMarks> {
        val found = HashMap<String, ResultMarks>()
        synchronized(known) { results.forEach { id -> known[id]?.let { found[id] = it } } }
        for (some in results.filter { it !in found }.chunked(AT_ONCE)) found += read(handle, some)
        synchronized(known) { known.putAll(found) }
        return found
    }

    private fun read(
        handle: Handle,
        results: List<String>,
    ): Map<String, ResultMarks> {
        val pictures = pictures(handle, results)
        val shared =
            query(
                handle,
                "SELECT * FROM diagnostics WHERE result_id IN (<results>) AND message_data LIKE :said",
                results,
            ).bind("said", "%\"cause.shared%")
                .map { row, _ -> row.getString("result_id") to said(row) }
                .list()
                .toMap()
        val cases =
            query(
                handle,
                """SELECT result_id, position, name, visibility, verdict, message, message_data FROM case_results
                   WHERE result_id IN (<results>) ORDER BY position""",
                results,
            ).map { row, _ -> row.getString("result_id") to mark(row, pictures) }
                .list()
                .filter { (_, mark) -> CaseReport.ownTitle(mark.name, "en").isEmpty }
                .groupBy({ it.first }, { it.second })
        return results.associateWith { ResultMarks(cases[it].orEmpty(), shared[it] ?: Message.NONE) }
    }

    private fun mark(
        row: ResultSet,
        pictures: Map<Pair<String, Int>, Pictures>,
    ): CaseMark {
        val drawn = pictures[row.getString("result_id") to row.getInt("position")]
        val verdict = GradingVerdict.valueOf(row.getString("verdict"))
        return CaseMark(
            row.getString("name").intern(),
            Disclosure.valueOf(row.getString("visibility")),
            verdict,
            if (verdict in TOLD) said(row) else Message.NONE,
            drawn?.answer.orEmpty(),
            drawn?.pixels ?: false,
        )
    }

    private fun said(row: ResultSet) = Message.ofData(row.getString("message_data"), row.getString("message"))

    private fun pictures(
        handle: Handle,
        results: List<String>,
    ): Map<Pair<String, Int>, Pictures> {
        val found = HashMap<Pair<String, Int>, Pictures>()
        query(
            handle,
            """SELECT result_id, case_position, kind, part, png_hash,
                   CASE WHEN kind = '${CasePicture.ACTUAL}' AND png_hash IS NULL THEN png END AS not_hashed
               FROM case_pictures WHERE result_id IN (<results>)
                   AND kind IN ('${CasePicture.ACTUAL}', '${CasePicture.DIFFERENCE}')""",
            results,
        ).map { row, _ ->
            val of = found.getOrPut(row.getString("result_id") to row.getInt("case_position")) { Pictures() }
            if (row.getString("kind") == CasePicture.ACTUAL) {
                of.answer = row.getString("png_hash") ?: hash(row.getBytes("not_hashed"))
            } else if (row.getString("part") != null) {
                of.pixels = true
            }
            of
        }.list()
        return found
    }

    private fun query(
        handle: Handle,
        sql: String,
        results: List<String>,
    ): Query = handle.createQuery(sql).bindList("results", results)

    private class Pictures {
        var answer = ""
        var pixels = false
    }

    private companion object {
        /** Verdicts whose words tell one wrong answer from another, and are the same for the same program. */
        val TOLD = setOf(GradingVerdict.WRONG, GradingVerdict.RUNTIME_ERROR)

        /** Results that are kept, of some 20 kB each. */
        const val MOST = 1_000

        /** Results that one statement asks for. */
        const val AT_ONCE = 200
    }
}
