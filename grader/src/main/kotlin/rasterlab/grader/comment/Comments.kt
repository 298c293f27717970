package rasterlab.grader.comment

import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.course.Identity
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import rasterlab.grader.storage.Secrets
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submission
import java.time.InstantSource

/** Keeps what staff and the student say about a submission; whoever calls has made sure that they may see it. */
class Comments(
    private val database: Database,
    private val clock: InstantSource,
) {
    /** Reads all of a submission, in the order of writing. */
    fun of(submission: String): List<LineComment> = database.read { CommentRows(it).of(submission) }

    /** @throws Rejection.UnknownComment where the submission has none of that id */
    fun find(
        submission: Submission,
        id: String,
    ): LineComment = database.read { CommentRows(it).find(submission.id, id) }

    /**
     * Reads comments of a submission, in the order of writing.
     *
     * @throws Rejection.Malformed where the submission has none of the id behind which the part begins
     */
    fun part(
        submission: String,
        paging: Paging,
    ): ListPart<LineComment> =
        database.read { handle ->
            val rows = CommentRows(handle)
            val last = paging.after?.let { rows.seek(submission, it) ?: throw paging.unknown() }
            paging.cut(rows.of(submission, last, paging.reach)) { it.id }
        }

    /**
     * Begins a thread: a comment of staff, or a question of the student, which is open.
     *
     * @param lines null for the whole submission
     * @param key what the sender calls this request, so that repeating it says nothing twice
     */
    fun write(
        who: Identity,
        submission: Submission,
        lines: CommentedLines?,
        text: CommentText,
        key: String?,
    ): LineComment {
        val there = linesOf(submission.source)
        if (lines != null && lines.last > there) throw Rejection.BadComment("lines", lines.first, lines.last, there)
        return store(who, submission, key, lines, thread = null, text)
    }

    /**
     * Answers in a thread. Words of the student open it; those of staff close it.
     *
     * @param thread id of the comment that began it
     * @param key what the sender calls this request, so that repeating it says nothing twice
     */
    fun answer(
        who: Identity,
        submission: Submission,
        thread: String,
        text: CommentText,
        key: String?,
    ): LineComment = store(who, submission, key, lines = null, thread, text)

    private fun store(
        who: Identity,
        submission: Submission,
        key: String?,
        lines: CommentedLines?,
        thread: String?,
        text: CommentText,
    ): LineComment {
        val request = Repeatable("comments ${who.id}", key, "${submission.id} $lines $thread ${text.text}")
        return database.write { handle ->
            val rows = CommentRows(handle)
            request.made(handle)?.let { return@write rows.find(submission.id, it) }
            val most = if (who is Identity.StudentIdentity) MOST_OF_STUDENT else MOST_OF_STAFF
            if (rows.countBy(who, submission) >= most) throw Rejection.BadComment("many", most)
            val begun = thread?.let { rows.find(submission.id, it) }
            if (begun?.thread != null) throw Rejection.BadComment("thread")
            val id = Secrets.newId()
            val now = clock.instant()
            rows.insert(id, submission.id, who.id, thread, lines, text.text, now)
            rows.setOpen(thread ?: id, who is Identity.StudentIdentity)
            note(handle, who, submission, if (thread == null) "comment" else "comment-answer", lines ?: begun?.lines)
            request.remember(handle, id, now)
            rows.find(submission.id, id)
        }
    }

    /**
     * Changes the words of one's own comment; that it was changed is shown.
     *
     * @throws Rejection.ForeignComment where somebody else wrote it
     */
    fun edit(
        who: Identity,
        submission: Submission,
        id: String,
        text: CommentText,
    ): LineComment =
        database.write { handle ->
            val rows = CommentRows(handle)
            val found = rows.own(who, submission, id)
            if (found.text == text.text) return@write found
            rows.edit(id, text.text, clock.instant())
            note(handle, who, submission, "comment-edit", found.lines)
            rows.find(submission.id, id)
        }

    /**
     * Deletes one's own comment, as long as nobody answered it.
     *
     * @throws Rejection.ForeignComment where somebody else wrote it
     */
    fun delete(
        who: Identity,
        submission: Submission,
        id: String,
    ): LineComment =
        database.write { handle ->
            val rows = CommentRows(handle)
            val found = rows.own(who, submission, id)
            if (rows.hasAnswers(id)) throw Rejection.BadComment("answered")
            rows.delete(id)
            note(handle, who, submission, "comment-delete", found.lines)
            found
        }

    /** Closes an open thread without a word: the question is answered, or has answered itself. */
    fun settle(
        who: Identity,
        submission: Submission,
        id: String,
    ): LineComment =
        database.write { handle ->
            val rows = CommentRows(handle)
            val found = rows.find(submission.id, id)
            if (!found.open) throw Rejection.BadComment("settled")
            rows.setOpen(id, open = false)
            note(handle, who, submission, "comment-settle", found.lines)
            rows.find(submission.id, id)
        }

    /**
     * Reads open questions of a course, the oldest first.
     *
     * @throws Rejection.Malformed where no comment has the id behind which the part begins
     */
    fun questions(
        course: String,
        paging: Paging,
    ): ListPart<OpenQuestion> =
        database.read { handle -> paging.cut(CommentRows(handle).questions(course, paging)) { it.comment.id } }

    /** How many questions wait in each course that has some, by the course's id. */
    fun openCounts(): Map<String, Int> = database.read { CommentRows(it).openCounts() }

    /** Notes what staff do; a student says things about their own work only. */
    private fun note(
        handle: Handle,
        who: Identity,
        submission: Submission,
        action: String,
        lines: CommentedLines?,
    ) {
        if (who !is Identity.StaffIdentity) return
        val course =
            handle
                .createQuery("SELECT course_id FROM students WHERE id = :student")
                .bind("student", submission.student)
                .mapTo(String::class.java)
                .one()
        AuditNote(who.id, course, action, submission.id, lines?.toString().orEmpty()).write(handle, clock.instant())
    }

    companion object {
        /** The most comments that a student writes about one submission, and all staff together. */
        const val MOST_OF_STUDENT = 50
        const val MOST_OF_STAFF = 200

        /** How many lines a source has, counted as the compiler does; an end of line begins no further one at the end. */
        internal fun linesOf(source: String): Int =
            source
                .removeSuffix("\n")
                .removeSuffix("\r")
                .lineSequence()
                .count()
    }
}
