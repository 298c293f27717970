package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import java.sql.ResultSet
import java.time.Instant

/**
 * A change as it was noted.
 *
 * @param by id of the account, or "command" for the server's machine
 * @param byName the name of that account; empty where it has none
 * @param role of that account; empty for the server's machine
 * @param course its name; null for what belongs to the whole server
 * @param subjectName what the id in [subject] is called, a submission and an extension by its student, a regrade by its
 *     exercise; null where it is none, or is gone
 * @param deletedNumber the number that the course had given the student in [subject], who was deleted; null for
 *     all others
 * @param exercise the id of that of the submission in [subject]; null where that is none
 * @param case the name of the only case that a regrade is of; null where it is of all, and of any other change
 */
data class AuditEntry(
    val id: String,
    val notedAt: Instant,
    val by: String,
    val byName: String,
    val role: String,
    val course: String?,
    val action: String,
    val subject: String,
    val subjectName: String?,
    val deletedNumber: Int?,
    val detail: String,
    val exercise: String?,
    val case: String?,
)

/** Reads what staff changed, the latest first. */
class Audit(
    private val database: Database,
) {
    /** @throws Rejection.Malformed where no entry has the id behind which the part begins */
    fun part(paging: Paging): ListPart<AuditEntry> =
        database.read { handle ->
            val last = paging.after
            if (last != null && !exists(handle, last)) throw paging.unknown()
            val read =
                handle
                    .createQuery("$SELECT ${if (last == null) "" else EARLIER} $ORDER LIMIT :most")
                    .apply { if (last != null) bind("before", last) }
                    .bind("most", paging.reach)
                    .map { row, _ -> entry(row) }
                    .list()
            paging.cut(read) { it.id }
        }

    private fun exists(
        handle: Handle,
        id: String,
    ) = handle
        .createQuery("SELECT count(*) FROM audit WHERE id = :id")
        .bind("id", id)
        .mapTo(Int::class.javaObjectType)
        .one() > 0

    private fun entry(row: ResultSet) =
        AuditEntry(
            row.getString("id"),
            Instant.parse(row.getString("noted_at")),
            row.getString("account_id"),
            row.getString("by_name").orEmpty(),
            row.getString("role").orEmpty(),
            row.getString("course_name"),
            row.getString("action"),
            row.getString("subject"),
            row.getString("subject_name"),
            row.getString("deletion")?.let { NUMBER.find(it) }?.run { groupValues[1].toInt() },
            row.getString("detail"),
            row.getString("exercise"),
            row.getString("case_name"),
        )

    companion object {
        /** Beginning of what a student's deletion notes. */
        private val NUMBER = Regex("^number (\\d+),")

        private const val SELECT =
            """SELECT audit.*, doers.name AS by_name, doers.role, courses.name AS course_name, regrades.case_name,
                   submissions.exercise,
                   deletions.detail AS deletion,
                   coalesce(students.shown_name, others.name, earlier.name, authors.shown_name, extended.shown_name,
                       regrades.exercise)
                       AS subject_name
               FROM audit
               LEFT JOIN instructors AS doers ON doers.id = audit.account_id
               LEFT JOIN courses ON courses.id = audit.course_id
               LEFT JOIN students ON students.id = audit.subject
               LEFT JOIN instructors AS others ON others.id = audit.subject
               LEFT JOIN courses AS earlier ON earlier.id = audit.subject
               LEFT JOIN submissions ON submissions.id = audit.subject
               LEFT JOIN students AS authors ON authors.id = submissions.student_id
               LEFT JOIN students AS extended ON audit.action = 'extension' AND audit.subject LIKE '% ' || extended.id
               LEFT JOIN regrades ON regrades.id = audit.subject
               LEFT JOIN audit AS deletions ON deletions.action = 'delete'
                   AND (audit.subject = deletions.subject OR audit.subject LIKE '% ' || deletions.subject)"""
        private const val EARLIER =
            """JOIN audit AS seen ON seen.id = :before
               WHERE audit.noted_at < seen.noted_at OR (audit.noted_at = seen.noted_at AND audit.id < seen.id)"""
        private const val ORDER = "ORDER BY audit.noted_at DESC, audit.id DESC"
    }
}
