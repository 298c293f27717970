package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Duration
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** Who may come in: by token, or by a session that a token opened. */
class Accounts(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** Who holds this token, or null. */
    fun holder(token: String): Identity? = database.read { find(it, "token_hash", Secrets.hash(token)) }

    /** Who opened this session, or null if nobody did or it is over. */
    fun inSession(session: String): Identity? =
        database.read { handle ->
            handle
                .createQuery("SELECT account_id FROM sessions WHERE token_hash = :hash AND expires_at > :now")
                .bind("hash", Secrets.hash(session))
                .bind("now", clock.instant().text())
                .mapTo(String::class.java)
                .findOne()
                .getOrNull()
                ?.let { find(handle, "id", it) }
        }

    /** Opens a session of [SESSION_LENGTH]. */
    fun open(who: Identity): String {
        val session = Secrets.newToken()
        database.write { handle ->
            handle
                .createUpdate(
                    "DELETE FROM sessions WHERE expires_at <= :now",
                ).bind("now", clock.instant().text())
                .execute()
            handle
                .createUpdate(
                    "INSERT INTO sessions (token_hash, account_id, expires_at) VALUES (:hash, :account, :expires)",
                ).bind("hash", Secrets.hash(session))
                .bind("account", who.id)
                .bind("expires", (clock.instant() + SESSION_LENGTH).text())
                .execute()
        }
        return session
    }

    fun close(session: String) {
        database.write {
            it
                .createUpdate(
                    "DELETE FROM sessions WHERE token_hash = :hash",
                ).bind("hash", Secrets.hash(session))
                .execute()
        }
    }

    /**
     * The first instructor's token, in a database where none was told to anybody yet; otherwise null.
     * A server that dies before [instructorAnnounced] makes another one at its next start.
     */
    fun newInstructorToken(): String? {
        val token = Secrets.newToken()
        val created =
            database.write { handle ->
                handle.execute("DELETE FROM instructors WHERE announced_at IS NULL")
                handle
                    .createUpdate(
                        """INSERT INTO instructors (id, token_hash, created_at)
                           SELECT :id, :hash, :now WHERE NOT EXISTS (SELECT 1 FROM instructors)""",
                    ).bind("id", Secrets.newId())
                    .bind("hash", Secrets.hash(token))
                    .bind("now", clock.instant().text())
                    .execute()
            }
        return token.takeIf { created == 1 }
    }

    /** The new instructor token has been printed. */
    fun instructorAnnounced() {
        database.write {
            it.createUpdate("UPDATE instructors SET announced_at = :now").bind("now", clock.instant().text()).execute()
        }
    }

    /** A new token for the instructor, whose old one and sessions end; null where there is no instructor yet. */
    fun renewInstructor(): String? {
        val token = Secrets.newToken()
        return database.write { handle ->
            val first = "SELECT id FROM instructors ORDER BY created_at LIMIT 1"
            val id =
                handle
                    .createQuery(first)
                    .mapTo(String::class.java)
                    .findOne()
                    .getOrNull() ?: return@write null
            handle
                .createUpdate("UPDATE instructors SET token_hash = :hash, announced_at = :now WHERE id = :id")
                .bind("hash", Secrets.hash(token))
                .bind("now", clock.instant().text())
                .bind("id", id)
                .execute()
            endSessions(handle, id)
            token
        }
    }

    /**
     * A new token for a student, whose old one and sessions end; null where there is no such student.
     *
     * @param key what the sender calls this request, so that repeating it gives the same token
     */
    fun renewStudent(
        id: String,
        key: String?,
    ): String? =
        database.write { handle ->
            val request = Repeatable("token $id", key, id)
            val token = if (key == null) Secrets.newToken() else Secrets.derive(handle, "token $id $key")
            if (request.made(handle) != null) return@write token
            val changed =
                handle
                    .createUpdate("UPDATE students SET token_hash = :hash WHERE id = :id")
                    .bind("hash", Secrets.hash(token))
                    .bind("id", id)
                    .execute()
            if (changed == 0) return@write null
            endSessions(handle, id)
            request.remember(handle, id, clock.instant())
            token
        }

    private fun endSessions(
        handle: Handle,
        account: String,
    ) {
        handle.createUpdate("DELETE FROM sessions WHERE account_id = :id").bind("id", account).execute()
    }

    private fun find(
        handle: Handle,
        column: String,
        value: String,
    ): Identity? =
        handle
            .createQuery("SELECT id, name, course_id FROM students WHERE $column = :value")
            .bind("value", value)
            .map { row, _ -> student(row) }
            .findOne()
            .or {
                handle
                    .createQuery("SELECT id FROM instructors WHERE $column = :value")
                    .bind("value", value)
                    .map { row, _ -> instructor(row) }
                    .findOne()
            }.getOrNull()

    private fun student(row: ResultSet): Identity =
        Identity.Student(row.getString("id"), row.getString("name"), row.getString("course_id"))

    private fun instructor(row: ResultSet): Identity = Identity.Instructor(row.getString("id"))

    companion object {
        val SESSION_LENGTH: Duration = Duration.ofDays(14)
    }
}
