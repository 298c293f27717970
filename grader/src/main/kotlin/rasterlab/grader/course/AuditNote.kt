package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.time.Instant

/**
 * Tells later who changed something; nothing secret goes into it.
 *
 * @param by id of the account, or "command"
 * @param course in which it was changed; null for what belongs to the whole server
 * @param action one word
 * @param subject what was changed
 */
internal class AuditNote(
    private val by: String,
    private val course: String?,
    private val action: String,
    private val subject: String,
    private val detail: String,
) {
    /** Writes it in the transaction of the change itself. */
    fun write(
        handle: Handle,
        now: Instant,
    ) {
        handle
            .createUpdate(
                """INSERT INTO audit (id, noted_at, account_id, course_id, action, subject, detail)
                   VALUES (:id, :now, :by, :course, :action, :subject, :detail)""",
            ).bind("id", Secrets.newId())
            .bind("now", now.text())
            .bind("by", by)
            .bind("course", course)
            .bind("action", action)
            .bind("subject", subject)
            .bind("detail", detail)
            .execute()
    }
}
