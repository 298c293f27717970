package rasterlab.grader.course

import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/** The rights that somebody of the staff has. */
enum class StaffRole(
    val code: String,
) {
    INSTRUCTOR("instructor"),
    ASSISTANT("assistant"),
    ;

    override fun toString() = code

    companion object {
        /** @throws Rejection.Malformed with the roles there are */
        fun of(code: String): StaffRole =
            entries.firstOrNull { it.code == code }
                ?: throw Rejection.Malformed("role is '$code', allowed are ${entries.joinToString { it.code }}")

        fun of(who: Identity.StaffIdentity): StaffRole =
            when (who) {
                is Identity.Instructor -> INSTRUCTOR
                is Identity.Assistant -> ASSISTANT
            }
    }
}

/**
 * One of the staff.
 *
 * @param name empty for the first instructor until somebody gives them one
 * @param course the single one that they teach; null for all
 * @param lastUsedAt to a few minutes; null where nobody came in yet
 * @param revokedAt since when no token lets them in; null where one does
 */
data class StaffMember(
    val id: String,
    val name: String,
    val role: StaffRole,
    val course: Course?,
    val madeAt: Instant,
    val lastUsedAt: Instant?,
    val revokedAt: Instant?,
)

/** Who teaches: instructors and assistants of the whole server or of one course, with a token each. */
class Staff(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** Reads all, those without access last. */
    fun all(): List<StaffMember> =
        database.read { handle ->
            handle
                .createQuery(
                    """$SELECT
                       ORDER BY CASE WHEN revoked_at IS NULL THEN 0 ELSE 1 END, role DESC, i.created_at, i.id""",
                ).map { row, _ -> member(row) }
                .list()
        }

    fun find(id: String): StaffMember = database.read { find(it, id) }

    /**
     * Takes somebody in.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it gives the same token
     * @param course id or code of the single one that they teach; null for all
     * @throws Rejection.UnknownCourse
     */
    fun add(
        name: Name,
        role: StaffRole,
        by: String,
        key: String?,
        course: String? = null,
    ): NewToken =
        database.write { handle ->
            val only = course?.let { Courses.named(handle, it) }
            val asked = listOfNotNull(name.text, role.code, only?.id).joinToString(" ")
            val request = Repeatable("staff $by", key, asked)
            val token = if (key == null) Secrets.newToken() else Secrets.derive(handle, "staff $by $key")
            request.made(handle)?.let { return@write NewToken(it, token) }
            val id = Secrets.newId()
            handle
                .createUpdate(
                    """INSERT INTO instructors (id, name, role, course_id, token_hash, created_at, announced_at)
                       VALUES (:id, :name, :role, :course, :hash, :now, :now)""",
                ).bind("id", id)
                .bind("name", name.text)
                .bind("role", role.code)
                .bind("course", only?.id)
                .bind("hash", Secrets.hash(token))
                .bind("now", clock.instant().text())
                .execute()
            note(handle, by, "staff-add", id, listOfNotNull(role.code, only?.name).joinToString(", "))
            request.remember(handle, id, clock.instant())
            NewToken(id, token)
        }

    /**
     * Makes a new token, with which also somebody comes in again whose access was taken away; the old one and its
     * sessions end.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it gives the same token
     */
    fun renew(
        id: String,
        by: String,
        key: String?,
    ): NewToken =
        database.write { handle ->
            val role = find(handle, id).role
            val request = Repeatable("staff token $id", key, id)
            val token = if (key == null) Secrets.newToken() else Secrets.derive(handle, "staff token $id $key")
            if (request.made(handle) != null) return@write NewToken(id, token)
            handle
                .createUpdate("UPDATE instructors SET token_hash = :hash, revoked_at = NULL WHERE id = :id")
                .bind("hash", Secrets.hash(token))
                .bind("id", id)
                .execute()
            Accounts.endSessions(handle, id)
            note(handle, by, "staff-token", id, role.code)
            request.remember(handle, id, clock.instant())
            NewToken(id, token)
        }

    /**
     * Takes the access away; what they did stays under their name. Doing it twice changes nothing more.
     *
     * @param by who does it, for the audit
     * @throws Rejection.LastInstructor where nobody could give access afterwards
     */
    fun revoke(
        id: String,
        by: String,
    ): StaffMember =
        database.write { handle ->
            val found = find(handle, id)
            if (found.revokedAt != null) return@write found
            requireAnother(handle, found)
            handle
                .createUpdate("UPDATE instructors SET revoked_at = :now WHERE id = :id")
                .bind("now", clock.instant().text())
                .bind("id", id)
                .execute()
            Accounts.endSessions(handle, id)
            note(handle, by, "staff-revoke", id, found.role.code)
            find(handle, id)
        }

    /**
     * Gives somebody another name, under which also stands what they did before.
     *
     * @param by who does it, for the audit
     */
    fun rename(
        id: String,
        name: Name,
        by: String,
    ): StaffMember = change(id) { rename(it, id, name, by) }

    /**
     * Gives somebody a single course, or all.
     *
     * @param course its id or code; null for all
     * @param by who does it, for the audit
     * @throws Rejection.UnknownCourse
     * @throws Rejection.LastInstructor where nobody could give access afterwards
     */
    fun assign(
        id: String,
        course: String?,
        by: String,
    ): StaffMember = change(id) { assign(it, id, course, by) }

    /**
     * Does both, or nothing where one cannot be.
     *
     * @param course its id or code; null for all
     * @throws Rejection.UnknownCourse
     * @throws Rejection.LastInstructor where nobody could give access afterwards
     */
    fun renameAndAssign(
        id: String,
        name: Name,
        course: String?,
        by: String,
    ): StaffMember =
        change(id) {
            rename(it, id, name, by)
            assign(it, id, course, by)
        }

    private fun change(
        id: String,
        work: (Handle) -> Unit,
    ): StaffMember =
        database.write { handle ->
            work(handle)
            find(handle, id)
        }

    private fun rename(
        handle: Handle,
        id: String,
        name: Name,
        by: String,
    ) {
        val found = find(handle, id)
        if (found.name == name.text) return
        handle
            .createUpdate("UPDATE instructors SET name = :name WHERE id = :id")
            .bind("name", name.text)
            .bind("id", id)
            .execute()
        note(handle, by, "staff-name", id, "${found.name} → ${name.text}".trim())
    }

    private fun assign(
        handle: Handle,
        id: String,
        course: String?,
        by: String,
    ) {
        val found = find(handle, id)
        val only = course?.let { Courses.named(handle, it) }
        if (found.course?.id == only?.id) return
        if (found.revokedAt == null) requireAnother(handle, found)
        handle
            .createUpdate("UPDATE instructors SET course_id = :course WHERE id = :id")
            .bind("course", only?.id)
            .bind("id", id)
            .execute()
        note(handle, by, "staff-course", id, "${told(found.course)} → ${told(only)}")
    }

    private fun told(course: Course?) = course?.name ?: "*"

    /** Refuses to take from [found] what nobody else could give back. */
    private fun requireAnother(
        handle: Handle,
        found: StaffMember,
    ) {
        val gives = found.role == StaffRole.INSTRUCTOR && found.course == null
        if (gives && instructors(handle) == 1) throw Rejection.LastInstructor()
    }

    private fun note(
        handle: Handle,
        by: String,
        action: String,
        id: String,
        detail: String,
    ) = AuditNote(by, course = null, action, id, detail).write(handle, clock.instant())

    private fun instructors(handle: Handle): Int =
        handle
            .createQuery(
                """SELECT count(*) FROM instructors
                   WHERE role = 'instructor' AND revoked_at IS NULL AND course_id IS NULL""",
            ).mapTo(Int::class.javaObjectType)
            .one()

    private fun find(
        handle: Handle,
        id: String,
    ): StaffMember =
        handle
            .createQuery("$SELECT WHERE i.id = :id")
            .bind("id", id)
            .map { row, _ -> member(row) }
            .findOne()
            .getOrNull() ?: throw Rejection.UnknownStaff(id)

    private fun member(row: ResultSet) =
        StaffMember(
            row.getString("id"),
            row.getString("name"),
            StaffRole.of(row.getString("role")),
            row.getString("course_id")?.let { Course(it, row.getString("course_name"), row.getString("course_code")) },
            Instant.parse(row.getString("created_at")),
            row.getString("last_used_at")?.let(Instant::parse),
            row.getString("revoked_at")?.let(Instant::parse),
        )

    private companion object {
        const val SELECT =
            """SELECT i.*, courses.name AS course_name, courses.code AS course_code
               FROM instructors AS i LEFT JOIN courses ON courses.id = i.course_id"""
    }
}

/** @param token shown this once */
data class NewToken(
    val id: String,
    val token: String,
)
