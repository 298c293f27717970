package rasterlab.grader.comment

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Course
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import java.sql.ResultSet
import java.time.Instant
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * A comment that staff of a course choose again by its name.
 *
 * @param by id of the account that kept it
 */
data class ReadyComment(
    val id: String,
    val name: String,
    val text: String,
    val by: String,
    val keptAt: Instant,
)

/** Keeps comments under short names, for each course. */
class KeptComments(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** Reads all of a course, by name. */
    fun of(course: String): List<ReadyComment> =
        database.read { handle ->
            handle
                .createQuery("SELECT * FROM kept_comments WHERE course_id = :course ORDER BY name, id")
                .bind("course", course)
                .map { row, _ -> ready(row) }
                .list()
        }

    /** @throws Rejection.UnknownComment where the course keeps none of that id */
    fun find(
        course: String,
        id: String,
    ): ReadyComment = database.read { find(it, course, id) }

    /**
     * Keeps a comment.
     *
     * @param key what the sender calls this request, so that repeating it keeps nothing twice
     * @throws Rejection.BadComment where the name is taken, or the course has [MOST] already
     */
    fun keep(
        who: Identity.StaffIdentity,
        course: String,
        name: Name,
        text: CommentText,
        key: String?,
    ): ReadyComment {
        val request = Repeatable("kept comments ${who.id}", key, "$course ${name.text} ${text.text}")
        return database.write { handle ->
            request.made(handle)?.let { return@write find(handle, course, it) }
            val there = names(handle, course)
            if (name.text in there) throw Rejection.BadComment("taken", name.text)
            if (there.size >= MOST) throw Rejection.BadComment("full", MOST)
            val id = Secrets.newId()
            val now = clock.instant()
            handle
                .createUpdate(
                    """INSERT INTO kept_comments (id, course_id, name, text, account_id, kept_at)
                       VALUES (:id, :course, :name, :text, :by, :now)""",
                ).bind("id", id)
                .bind("course", course)
                .bind("name", name.text)
                .bind("text", text.text)
                .bind("by", who.id)
                .bind("now", now.text())
                .execute()
            AuditNote(who.id, course, "comment-keep", id, name.text).write(handle, now)
            request.remember(handle, id, now)
            find(handle, course, id)
        }
    }

    /** Keeps it no longer; what was written with it stays. */
    fun drop(
        who: Identity.StaffIdentity,
        course: String,
        id: String,
    ): ReadyComment =
        database.write { handle ->
            val found = find(handle, course, id)
            handle.createUpdate("DELETE FROM kept_comments WHERE id = :id").bind("id", id).execute()
            AuditNote(who.id, course, "comment-drop", id, found.name).write(handle, clock.instant())
            found
        }

    private fun names(
        handle: Handle,
        course: String,
    ): List<String> =
        handle
            .createQuery("SELECT name FROM kept_comments WHERE course_id = :course")
            .bind("course", course)
            .mapTo(String::class.java)
            .list()

    private fun find(
        handle: Handle,
        course: String,
        id: String,
    ): ReadyComment =
        handle
            .createQuery("SELECT * FROM kept_comments WHERE id = :id AND course_id = :course")
            .bind("id", id)
            .bind("course", course)
            .map { row, _ -> ready(row) }
            .findOne()
            .getOrNull() ?: throw Rejection.UnknownComment(id)

    private fun ready(row: ResultSet) =
        ReadyComment(
            row.getString("id"),
            row.getString("name"),
            row.getString("text"),
            row.getString("account_id"),
            Instant.parse(row.getString("kept_at")),
        )

    companion object {
        /** The most that a course keeps. */
        const val MOST = 100
    }
}

/** Lets a new course keep the comments of another too, within a transaction. */
internal fun copyKeptComments(
    handle: Handle,
    from: Course,
    to: Course,
) {
    val kept =
        handle
            .createQuery("SELECT id FROM kept_comments WHERE course_id = :course")
            .bind("course", from.id)
            .mapTo(String::class.java)
            .list()
    val insert =
        handle.prepareBatch(
            """INSERT INTO kept_comments (id, course_id, name, text, account_id, kept_at)
               SELECT :id, :course, name, text, account_id, kept_at FROM kept_comments WHERE id = :from""",
        )
    kept.forEach {
        insert
            .bind("id", Secrets.newId())
            .bind("course", to.id)
            .bind("from", it)
            .add()
    }
    if (kept.isNotEmpty()) insert.execute()
}
