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

/** Keeps reports, one for each submission and revision of its exercise. */
class Reports(
    private val database: Database,
) {
    /** The latest report of a submission, with nothing hidden, or null. */
    fun of(submission: String): Recorded? =
        database.read { handle ->
            handle
                .createQuery("SELECT * FROM results WHERE submission_id = :id ORDER BY graded_at DESC LIMIT 1")
                .bind("id", submission)
                .map { row, _ ->
                    val revision = row.getString("revision")
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
                            cases(handle, submission, revision),
                            diagnostics(handle, submission, revision),
                            row.getString("isolation"),
                            row.getDouble("nanos_per_item"),
                            Optional.ofNullable(SpeedRows(handle, submission, revision).of(row)),
                        ),
                        revision,
                        Instant.parse(row.getString("graded_at")),
                    )
                }.findOne()
                .getOrNull()
        }

    /** Writes a report in the transaction of [handle]. */
    fun insert(
        handle: Handle,
        submission: String,
        revision: String,
        report: Report,
        gradedAt: Instant,
    ) {
        handle
            .createUpdate(
                """INSERT INTO results (submission_id, revision, verdict, accuracy, stability, speed, points_of,
                       isolation, nanos_per_item, graded_at)
                   VALUES (:id, :revision, :verdict, :accuracy, :stability, :speed, :of, :isolation, :nanos, :now)""",
            ).bind("id", submission)
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
        SpeedRows(handle, submission, revision).replace(report.figures().getOrNull())
        for ((position, case) in report.cases().withIndex()) {
            insert(handle, submission, revision, position, case)
        }
        for ((position, diagnostic) in report.diagnostics().withIndex()) {
            insert(handle, submission, revision, position, diagnostic)
        }
    }

    /** Puts the speed of [report] in the place of that of the latest one, in the transaction of [handle]. */
    fun replaceSpeed(
        handle: Handle,
        submission: String,
        report: Report,
    ) {
        val speed = report.speed().orElseThrow()
        val last = "(SELECT max(graded_at) FROM results WHERE submission_id = :id)"
        val latest = "submission_id = :id AND graded_at = $last"
        handle
            .createUpdate(
                """UPDATE case_results SET verdict = :verdict, points = :points, message = :message, message_data = :data
                   WHERE submission_id = :id AND name = :name
                       AND revision = (SELECT revision FROM results WHERE $latest)""",
            ).bind("id", submission)
            .bind("name", speed.name())
            .bind("verdict", speed.verdict().name)
            .bind("points", speed.points())
            .bind("message", speed.message())
            .bind("data", speed.said().data())
            .execute()
        handle
            .createUpdate("UPDATE results SET speed = :points, nanos_per_item = :nanos WHERE $latest")
            .bind("id", submission)
            .bind("points", speed.points())
            .bind("nanos", report.nanosPerItem())
            .execute()
        val revision =
            handle
                .createQuery("SELECT revision FROM results WHERE $latest")
                .bind("id", submission)
                .mapTo(String::class.java)
                .one()
        SpeedRows(handle, submission, revision).replace(report.figures().getOrNull())
    }

    private fun insert(
        handle: Handle,
        submission: String,
        revision: String,
        position: Int,
        case: CaseReport,
    ) {
        handle
            .createUpdate(
                """INSERT INTO case_results (submission_id, revision, position, name, visibility, verdict, points, points_of,
                       message, message_data, scene)
                   VALUES (:id, :revision, :position, :name, :visibility, :verdict, :points, :of,
                       :message, :data, :scene)""",
            ).bind("id", submission)
            .bind("revision", revision)
            .bind("position", position)
            .bind("name", case.name())
            .bind("visibility", case.visibility().name)
            .bind("verdict", case.verdict().name)
            .bind("points", case.points())
            .bind("of", case.of())
            .bind("message", case.message())
            .bind("data", case.said().data())
            .bind("scene", case.scene())
            .execute()
        PictureRows(handle, submission, revision).insert(position, case.pictures())
    }

    private fun insert(
        handle: Handle,
        submission: String,
        revision: String,
        position: Int,
        diagnostic: Diagnostic,
    ) {
        handle
            .createUpdate(
                """INSERT INTO diagnostics (submission_id, revision, position, line, column_number, message, message_data)
                   VALUES (:id, :revision, :position, :line, :column, :message, :data)""",
            ).bind("id", submission)
            .bind("revision", revision)
            .bind("position", position)
            .bind("line", diagnostic.line())
            .bind("column", diagnostic.column())
            .bind("message", diagnostic.message())
            .bind("data", diagnostic.said().data())
            .execute()
    }

    private fun cases(
        handle: Handle,
        submission: String,
        revision: String,
    ): List<CaseReport> {
        val pictures = PictureRows(handle, submission, revision).all()
        return handle
            .createQuery(
                "SELECT * FROM case_results WHERE submission_id = :id AND revision = :revision ORDER BY position",
            ).bind("id", submission)
            .bind("revision", revision)
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
        submission: String,
        revision: String,
    ): List<Diagnostic> =
        handle
            .createQuery(
                "SELECT * FROM diagnostics WHERE submission_id = :id AND revision = :revision ORDER BY position",
            ).bind("id", submission)
            .bind("revision", revision)
            .map { row, _ -> Diagnostic(row.getInt("line"), row.getInt("column_number"), said(row)) }
            .list()

    /**
     * The message in no language yet; only the English text is left where the row is older than its
     * data.
     */
    private fun said(row: ResultSet): Message = Message.ofData(row.getString("message_data"), row.getString("message"))
}
