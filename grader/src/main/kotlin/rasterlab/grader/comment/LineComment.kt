/*
 * Comments, questions and answers on lines of a submission, and comments that are kept for others.
 * Read LineComment, Comments, KeptComments, CommentRoutes, in this order.
 */
package rasterlab.grader.comment

import rasterlab.grader.problem.Rejection
import java.time.Instant

/** The lines [first] to [last] of a source, counted from 1. */
data class CommentedLines(
    val first: Int,
    val last: Int,
) {
    init {
        require(first in 1..last) { "lines $first to $last: expected 1 or more, the last not before the first" }
    }

    override fun toString() = if (first == last) "$first" else "$first–$last"
}

/** The words of a comment, with `\n` at the ends of lines. */
class CommentText private constructor(
    val text: String,
) {
    companion object {
        /** The most characters that a comment has. */
        const val MOST = 2000

        /** @throws Rejection.BadComment where it is empty, too long, or has control characters besides tabs and line ends */
        fun of(raw: String): CommentText {
            val text = raw.replace("\r\n", "\n").replace('\r', '\n').trim()
            if (text.length !in 1..MOST || text.codePoints().anyMatch(::isForbidden)) {
                throw Rejection.BadComment("text", text.length, MOST)
            }
            return CommentText(text)
        }

        private fun isForbidden(point: Int) =
            when (Character.getType(point).toByte()) {
                Character.CONTROL -> point.toChar() !in "\n\t"
                Character.SURROGATE -> true
                else -> false
            }
    }
}

/**
 * Something that was said about a submission.
 *
 * @param thread id of the comment or question that it answers; null where it begins a thread
 * @param lines null where it is about the whole submission, and in answers
 * @param by id of the account
 * @param name of who wrote it; empty for the first instructor, whom nobody named
 * @param role of who wrote it: student, instructor or assistant
 * @param editedAt null where it stands as it was written
 * @param open whether the student's last words in the thread that it begins wait for an answer
 */
data class LineComment(
    val id: String,
    val submission: String,
    val thread: String?,
    val lines: CommentedLines?,
    val by: String,
    val name: String,
    val role: String,
    val text: String,
    val writtenAt: Instant,
    val editedAt: Instant?,
    val open: Boolean,
)

/**
 * A question that waits for an answer.
 *
 * @param student the name that the course shows
 */
data class OpenQuestion(
    val comment: LineComment,
    val student: String,
    val exercise: String,
    val attempt: Int,
)
