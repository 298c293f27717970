package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.concurrent.ConcurrentHashMap
import kotlin.jvm.optionals.getOrNull

/** Who may come in: by token, or by a session that a token opened. */
class Accounts(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** When each of the staff was noted to have been here. */
    private val used = ConcurrentHashMap<String, Instant>()

    /** Who holds this token, or null. */
    fun holder(token: String): Identity? =
        database.read { find(it, "token_hash", Secrets.hash(token)) }?.also(::noteUse)

    /** Who has this id, where their access was not taken away; otherwise null. */
    fun withId(id: String): Identity? = database.read { find(it, "id", id) }

    /** Who opened this session, or null if nobody did or it is over. */
    fun inSession(session: String): Identity? =
        database
            .read { handle ->
                handle
                    .createQuery("SELECT account_id FROM sessions WHERE token_hash = :hash AND expires_at > :now")
                    .bind("hash", Secrets.hash(session))
                    .bind("now", clock.instant().text())
                    .mapTo(String::class.java)
                    .findOne()
                    .getOrNull()
                    ?.let { find(handle, "id", it) }
            }?.also(::noteUse)

    /** Remembers when somebody of the staff was here, so that a token that nobody uses is seen; not at every request. */
    private fun noteUse(who: Identity) {
        val now = clock.instant()
        if (who !is Identity.StaffIdentity) return
        val before = used[who.id]
        if (before != null && now >= before && now < before + USE_INTERVAL) return
        used[who.id] = now
        database.write {
            it
                .createUpdate("UPDATE instructors SET last_used_at = :now WHERE id = :id")
                .bind("now", now.text())
                .bind("id", who.id)
                .execute()
        }
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
            it
                .createUpdate("UPDATE instructors SET announced_at = :now WHERE announced_at IS NULL")
                .bind("now", clock.instant().text())
                .execute()
        }
    }

    /** A new token for the first instructor of all courses who has access, whose old one and sessions end; null where there is none. */
    fun renewInstructor(): String? {
        val token = Secrets.newToken()
        return database.write { handle ->
            val first =
                """SELECT id FROM instructors WHERE role = 'instructor' AND revoked_at IS NULL AND course_id IS NULL
                   ORDER BY created_at LIMIT 1"""
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
            AuditNote("command", course = null, "staff-token", id, "instructor").write(handle, clock.instant())
            token
        }
    }

    /**
     * A new token for a student, whose old one and sessions end; null where there is no such student.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it gives the same token
     */
    fun renewStudent(
        id: String,
        by: String,
        key: String?,
    ): String? =
        database.write { handle ->
            val request = Repeatable("token $id", key, id)
            val token = if (key == null) Secrets.newToken() else Secrets.derive(handle, "token $id $key")
            if (request.made(handle) != null) return@write token
            val course = courseOf(handle, id) ?: return@write null
            handle
                .createUpdate("UPDATE students SET token_hash = :hash, revoked_at = NULL WHERE id = :id")
                .bind("hash", Secrets.hash(token))
                .bind("id", id)
                .execute()
            endSessions(handle, id)
            AuditNote(by, course, "token", id, detail = "").write(handle, clock.instant())
            request.remember(handle, id, clock.instant())
            token
        }

    /**
     * Takes a student's token away, whose sessions end; their work stays, and a new token lets them in again.
     *
     * @param by who does it, for the audit
     * @return since when it is away
     * @throws Rejection.UnknownStudent
     */
    fun revokeStudent(
        id: String,
        by: String,
    ): Instant =
        database.write { handle ->
            val course = courseOf(handle, id) ?: throw Rejection.UnknownStudent(id)
            revokedSince(handle, id)?.let { return@write it }
            val now = clock.instant()
            handle
                .createUpdate("UPDATE students SET revoked_at = :now WHERE id = :id")
                .bind("now", now.text())
                .bind("id", id)
                .execute()
            endSessions(handle, id)
            AuditNote(by, course, "token-revoke", id, detail = "").write(handle, now)
            now
        }

    /** Notes that one of the staff looks at the pages as the student has them. */
    fun noteView(
        student: Identity.StudentIdentity,
        by: String,
    ) = database.write { AuditNote(by, student.course, "view", student.id, detail = "").write(it, clock.instant()) }

    /** Tells since when a student has no token; null where they have one. */
    fun revokedSince(student: String): Instant? = database.read { revokedSince(it, student) }

    private fun revokedSince(
        handle: Handle,
        student: String,
    ): Instant? =
        handle
            .createQuery("SELECT revoked_at FROM students WHERE id = :id AND revoked_at IS NOT NULL")
            .bind("id", student)
            .mapTo(String::class.java)
            .findOne()
            .map(Instant::parse)
            .getOrNull()

    private fun courseOf(
        handle: Handle,
        student: String,
    ): String? =
        handle
            .createQuery("SELECT course_id FROM students WHERE id = :id")
            .bind("id", student)
            .mapTo(String::class.java)
            .findOne()
            .getOrNull()

    private fun find(
        handle: Handle,
        column: String,
        value: String,
    ): Identity? =
        handle
            .createQuery("SELECT id, name, course_id FROM students WHERE $column = :value AND revoked_at IS NULL")
            .bind("value", value)
            .map { row, _ -> student(row) }
            .findOne()
            .or {
                handle
                    .createQuery(
                        """SELECT id, name, role, course_id FROM instructors
                           WHERE $column = :value AND revoked_at IS NULL""",
                    ).bind("value", value)
                    .map { row, _ -> staff(row) }
                    .findOne()
            }.getOrNull()

    private fun student(row: ResultSet): Identity =
        Identity.StudentIdentity(row.getString("id"), row.getString("name"), row.getString("course_id"))

    private fun staff(row: ResultSet): Identity =
        row.getString("course_id").let { course ->
            when (StaffRole.of(row.getString("role"))) {
                StaffRole.INSTRUCTOR -> Identity.Instructor(row.getString("id"), row.getString("name"), course)
                StaffRole.ASSISTANT -> Identity.Assistant(row.getString("id"), row.getString("name"), course)
            }
        }

    companion object {
        val SESSION_LENGTH: Duration = Duration.ofDays(14)

        /** How exactly it is known when somebody of the staff was here. */
        private val USE_INTERVAL: Duration = Duration.ofMinutes(5)

        /** Ends the sessions that the account's token opened. */
        internal fun endSessions(
            handle: Handle,
            account: String,
        ) {
            handle.createUpdate("DELETE FROM sessions WHERE account_id = :id").bind("id", account).execute()
        }
    }
}
