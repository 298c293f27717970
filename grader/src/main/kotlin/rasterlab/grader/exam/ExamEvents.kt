package rasterlab.grader.exam

import com.fasterxml.jackson.dataformat.csv.CsvGenerator
import com.fasterxml.jackson.dataformat.csv.CsvMapper
import com.fasterxml.jackson.dataformat.csv.CsvSchema
import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.Instant

/** The kinds of events at an exam. */
enum class ExamEventKind {
    OPENED,
    DRAFT,
    HAND_IN,
    NOT_TAKEN,
    ADDRESS,
    ADDRESS_REFUSED,
    SECOND_SESSION,
    SESSION_TAKEN_OVER,
    RELEASED,
    EXTRA,
    END,
    ;

    /** Lower-case with hyphens, as it is stored. */
    val code get() = name.lowercase().replace('_', '-')
}

/**
 * An event at an exam.
 *
 * @param name of the student, as the course shows it
 * @param address from which it came; empty where it came from nobody
 */
data class ExamEvent(
    val at: Instant,
    val student: String,
    val name: String,
    val kind: String,
    val address: String,
    val detail: String,
)

/** The protocol of an exam. */
internal object ExamEvents {
    private val csv: CsvMapper = CsvMapper().apply { enable(CsvGenerator.Feature.STRICT_CHECK_FOR_QUOTING) }

    fun note(
        handle: Handle,
        exam: String,
        student: String,
        at: Instant,
        kind: ExamEventKind,
        address: String = "",
        detail: String = "",
    ) {
        handle
            .createUpdate(
                """INSERT INTO exam_events (id, exam_id, student_id, number, noted_at, kind, address, detail)
                   SELECT :id, :exam, :student, coalesce(max(number), 0) + 1, :at, :kind, :address, :detail
                   FROM exam_events WHERE exam_id = :exam""",
            ).bind("id", Secrets.newId())
            .bind("exam", exam)
            .bind("student", student)
            .bind("at", at.text())
            .bind("kind", kind.code)
            .bind("address", address)
            .bind("detail", detail)
            .execute()
    }

    /** Whether a student handed that in at an exam. */
    fun tell(
        handle: Handle,
        sitting: Sitting,
        handedIn: String,
    ): Boolean =
        handle
            .createQuery(
                """SELECT count(*) FROM exam_events
                   WHERE exam_id = :exam AND student_id = :student AND kind = :kind AND detail = :detail""",
            ).bind("exam", sitting.exam.id)
            .bind("student", sitting.student)
            .bind("kind", ExamEventKind.HAND_IN.code)
            .bind("detail", handedIn)
            .mapTo(Int::class.javaObjectType)
            .one() > 0

    fun of(
        handle: Handle,
        exam: String,
    ): List<ExamEvent> =
        handle
            .createQuery(
                """SELECT e.*, students.shown_name FROM exam_events e JOIN students ON students.id = e.student_id
                   WHERE e.exam_id = :exam ORDER BY e.number""",
            ).bind("exam", exam)
            .map { row, _ ->
                ExamEvent(
                    Instant.parse(row.getString("noted_at")),
                    row.getString("student_id"),
                    row.getString("shown_name"),
                    row.getString("kind"),
                    row.getString("address"),
                    row.getString("detail"),
                )
            }.list()

    /** The events as CSV; a cell that a spreadsheet would take for a formula begins with an apostrophe. */
    fun csv(events: List<ExamEvent>): String {
        val rows =
            listOf(listOf("time", "student", "name", "event", "address", "detail")) +
                events.map { listOf(it.at.text(), it.student, it.name, it.kind, it.address, it.detail) }
        return csv
            .writer(CsvSchema.emptySchema().withLineSeparator("\r\n"))
            .writeValueAsString(rows.map { row -> row.map { if (it.firstOrNull() in FORMULA) "'$it" else it } })
    }

    private val FORMULA = "=+-@\t\r".toSet()
}
