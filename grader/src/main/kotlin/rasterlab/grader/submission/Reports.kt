package rasterlab.grader.submission

import org.jdbi.v3.core.Handle
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Diagnostic
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Instant
import java.util.Optional
import kotlin.jvm.optionals.getOrNull

/**
 * A report as it was recorded.
 *
 * @param revision of the exercise that it was graded against
 */
data class Recorded(
    val report: Report,
    val revision: String,
    val gradedAt: Instant,
)

/**
 * Keeps reports, one for each run of grading a submission. Another run adds to those of before and replaces none; one of
 * them is current, and only that one counts.
 */
class Reports(
    private val database: Database,
) {
    /** The current report of a submission, with nothing hidden, or null. */
    fun of(submission: String): Recorded? = recorded("submission_id = :id AND is_current = 1", submission)

    /** The report of a result by its id, with nothing hidden, or null. */
    fun at(result: String): Recorded? = recorded("id = :id", result)

    /** The current report of a submission, in the transaction of [handle]. */
    fun of(
        handle: Handle,
        submission: String,
    ): Recorded? = recorded(handle, "submission_id = :id AND is_current = 1", submission)

    private fun recorded(
        condition: String,
        id: String,
    ): Recorded? = database.read { recorded(it, condition, id) }

    private fun recorded(
        handle: Handle,
        condition: String,
        id: String,
    ): Recorded? =
        handle
            .createQuery("SELECT * FROM results WHERE $condition")
            .bind("id", id)
            .map { row, _ ->
                val result = row.getString("id")
                val points =
                    ScorePoints(
                        row.getInt("accuracy"),
                        row.getInt("stability"),
                        row.getInt("speed"),
                        row.getInt("points_of"),
                    )
                Recorded(
                    Report(
                        GradingVerdict.valueOf(row.getString("verdict").uppercase()),
                        points,
                        cases(handle, result),
                        diagnostics(handle, result),
                        row.getString("isolation"),
                        row.getDouble("nanos_per_item"),
                        Optional.ofNullable(SpeedRows(handle, result).of(row)),
                    ),
                    row.getString("revision"),
                    Instant.parse(row.getString("graded_at")),
                )
            }.findOne()
            .getOrNull()

    /**
     * Writes a report in the transaction of [handle].
     *
     * @param current whether it is the one that counts from now on
     * @return the id of the result
     */
    fun insert(
        handle: Handle,
        submission: String,
        revision: String,
        report: Report,
        gradedAt: Instant,
        current: Boolean = true,
    ): String {
        val result = Secrets.newId()
        if (current) {
            handle
                .createUpdate("UPDATE results SET is_current = 0 WHERE submission_id = :submission AND is_current = 1")
                .bind("submission", submission)
                .execute()
        }
        handle
            .createUpdate(
                """INSERT INTO results (id, submission_id, run, is_current, revision, verdict, accuracy, stability, speed,
                       points_of, isolation, nanos_per_item, graded_at)
                   SELECT :id, :submission, coalesce(max(run), 0) + 1, :current, :revision, :verdict, :accuracy, :stability, :speed,
                       :of, :isolation, :nanos, :now
                   FROM results WHERE submission_id = :submission""",
            ).bind("id", result)
            .bind("submission", submission)
            .bind("current", if (current) 1 else 0)
            .bind("revision", revision)
            .bind("verdict", report.verdict().code())
            .bind("accuracy", report.points().accuracy())
            .bind("stability", report.points().stability())
            .bind("speed", report.points().speed())
            .bind("of", report.points().of())
            .bind("isolation", report.isolation())
            .bind("nanos", report.nanosPerItem())
            .bind("now", gradedAt.text())
            .execute()
        SpeedRows(handle, result).replace(report.figures().getOrNull())
        for ((position, case) in report.cases().withIndex()) {
            insert(handle, result, position, case)
        }
        for ((position, diagnostic) in report.diagnostics().withIndex()) {
            insert(handle, result, position, diagnostic)
        }
        return result
    }

    /** Puts the speed of [report] in the place of that of the current one, in the transaction of [handle]. */
    fun replaceSpeed(
        handle: Handle,
        submission: String,
        report: Report,
    ) {
        val speed = report.speed().orElseThrow()
        val result =
            handle
                .createQuery("SELECT id FROM results WHERE submission_id = :id AND is_current = 1")
                .bind("id", submission)
                .mapTo(String::class.java)
                .one()
        handle
            .createUpdate(
                """UPDATE case_results SET verdict = :verdict, points = :points, message = :message, message_data = :data
                   WHERE result_id = :result AND name = :name""",
            ).bind("result", result)
            .bind("name", speed.name())
            .bind("verdict", speed.verdict().name)
            .bind("points", speed.points())
            .bind("message", speed.message())
            .bind("data", speed.explanation().data())
            .execute()
        handle
            .createUpdate("UPDATE results SET speed = :points, nanos_per_item = :nanos WHERE id = :result")
            .bind("result", result)
            .bind("points", speed.points())
            .bind("nanos", report.nanosPerItem())
            .execute()
        SpeedRows(handle, result).replace(report.figures().getOrNull())
    }

    private fun insert(
        handle: Handle,
        result: String,
        position: Int,
        case: CaseReport,
    ) {
        handle
            .createUpdate(
                """INSERT INTO case_results (result_id, position, name, visibility, verdict, points, points_of,
                       message, message_data, scene)
                   VALUES (:result, :position, :name, :visibility, :verdict, :points, :of,
                       :message, :data, :scene)""",
            ).bind("result", result)
            .bind("position", position)
            .bind("name", case.name())
            .bind("visibility", case.visibility().name)
            .bind("verdict", case.verdict().name)
            .bind("points", case.points())
            .bind("of", case.of())
            .bind("message", case.message())
            .bind("data", case.explanation().data())
            .bind("scene", case.scene())
            .execute()
        PictureRows(handle, result).insert(position, case.pictures())
    }

    private fun insert(
        handle: Handle,
        result: String,
        position: Int,
        diagnostic: Diagnostic,
    ) {
        handle
            .createUpdate(
                """INSERT INTO diagnostics (result_id, position, line, column_number, message, message_data)
                   VALUES (:result, :position, :line, :column, :message, :data)""",
            ).bind("result", result)
            .bind("position", position)
            .bind("line", diagnostic.line())
            .bind("column", diagnostic.column())
            .bind("message", diagnostic.message())
            .bind("data", diagnostic.explanation().data())
            .execute()
    }

    private fun cases(
        handle: Handle,
        result: String,
    ): List<CaseReport> {
        val pictures = PictureRows(handle, result).all()
        return handle
            .createQuery(
                "SELECT * FROM case_results WHERE result_id = :result ORDER BY position",
            ).bind("result", result)
            .map { row, _ ->
                CaseReport(
                    row.getString("name"),
                    Disclosure.valueOf(row.getString("visibility")),
                    GradingVerdict.valueOf(row.getString("verdict")),
                    row.getInt("points"),
                    row.getInt("points_of"),
                    said(row),
                    pictures[row.getInt("position")].orEmpty(),
                    row.getString("scene"),
                )
            }.list()
    }

    private fun diagnostics(
        handle: Handle,
        result: String,
    ): List<Diagnostic> =
        handle
            .createQuery(
                "SELECT * FROM diagnostics WHERE result_id = :result ORDER BY position",
            ).bind("result", result)
            .map { row, _ -> Diagnostic(row.getInt("line"), row.getInt("column_number"), said(row)) }
            .list()

    /**
     * The message in no language yet; only the English text is left where the row is older than its
     * data.
     */
    private fun said(row: ResultSet): Message = Message.ofData(row.getString("message_data"), row.getString("message"))
}
