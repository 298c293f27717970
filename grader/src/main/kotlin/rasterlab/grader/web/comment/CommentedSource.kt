// Comments beside the lines of a submission, and the pages of a course's questions. Start with CommentedSource.
package rasterlab.grader.web.comment

import io.ktor.http.Parameters
import kotlinx.html.FlowContent
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.id
import kotlinx.html.p
import kotlinx.html.span
import kotlinx.html.strong
import kotlinx.html.summary
import rasterlab.grader.comment.CommentedLines
import rasterlab.grader.comment.Comments
import rasterlab.grader.comment.KeptComments
import rasterlab.grader.comment.LineComment
import rasterlab.grader.comment.ReadyComment
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.submission.Submission
import rasterlab.grader.web.HandedView
import rasterlab.grader.web.NUMBERED_MOST
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.place
import rasterlab.grader.web.sourceLines

/** The source of a submission with threads below the lines that they are about, and forms to write more. */
class CommentedSource(
    private val comments: Comments,
    private val kept: KeptComments,
    private val courses: Courses,
) : HandedView {
    override fun show(
        place: FlowContent,
        texts: PageTexts,
        who: Identity,
        submission: Submission,
        title: String,
        typed: Parameters?,
    ) = with(place) {
        val said = comments.of(submission.id)
        val threads =
            said.filter { it.thread == null }.map { first ->
                CommentThread(
                    first,
                    said.filter {
                        it.thread ==
                            first.id
                    },
                )
            }
        val course = if (who is Identity.StaffIdentity) courses.ofStudent(submission.student)?.id else null
        val desk = CommentDesk(texts, who, submission, course, course?.let(kept::of).orEmpty(), typed)
        val refused = typed?.contains(CommentDesk.FORM) == true
        details {
            id = "handed"
            open = said.isNotEmpty() || refused
            summary { +if (said.isEmpty()) title else texts.say("comment.source", title, said.size) }
            threads(desk, threads.filter { it.first.lines == null })
            val placed = threads.filter { it.first.lines != null }
            val marked = placed.flatMap { it.first.lines?.numbers() ?: emptyList() }.toSet()
            val byEnd = placed.groupBy { it.first.lines?.last }
            sourceLines(submission.source, title, marked::contains) { line -> threads(desk, byEnd[line].orEmpty()) }
            threads(desk, byEnd.filterKeys { it != null && it > NUMBERED_MOST }.values.flatten())
            newThread(desk)
        }
    }
}

/** A comment or question, and what was answered to it. */
internal class CommentThread(
    val first: LineComment,
    val answers: List<LineComment>,
)

/**
 * The place of whoever looks at the comments on a submission.
 *
 * @param course of the student; null for a student who looks
 * @param kept the comments to choose from
 * @param typed what a form held that was refused, or null
 */
internal class CommentDesk(
    val texts: PageTexts,
    val who: Identity,
    val submission: Submission,
    val course: String?,
    val kept: List<ReadyComment>,
    private val typed: Parameters?,
) {
    val address = "/submissions/${submission.id}/comments"

    /** Returns what that form held when it was refused; null where it was not. */
    fun typedIn(form: String): Parameters? = typed?.takeIf { it[FORM] == form }

    companion object {
        /** The field that tells which form of the page was sent. */
        const val FORM = "form"
    }
}

private fun CommentedLines.numbers(): Iterable<Int> = first..last

private fun FlowContent.threads(
    desk: CommentDesk,
    threads: List<CommentThread>,
) = threads.forEach { thread ->
    div("thread") {
        id = "comment-${thread.first.id}"
        attributes["role"] = "group"
        attributes["aria-label"] = desk.texts.place(thread.first.lines)
        said(desk, thread.first, answered = thread.answers.isNotEmpty())
        thread.answers.forEach { said(desk, it, answered = false) }
        if (thread.first.open) p("waits") { +desk.texts.say("comment.open") }
        answering(desk, thread.first)
    }
}

private fun FlowContent.said(
    desk: CommentDesk,
    one: LineComment,
    answered: Boolean,
) = div("said") {
    p("by") {
        strong { +desk.texts.author(one) }
        +" "
        span("unbroken") { +desk.texts.say("comment.at", desk.texts.time(one.writtenAt)) }
        one.editedAt?.let { +", ${desk.texts.say("comment.edited", desk.texts.time(it))}" }
        if (one.thread == null) +" · ${desk.texts.place(one.lines)}"
    }
    p("words") { +one.text }
    controls(desk, one, answered)
}

/** Names whoever wrote it, with the role where the name says too little. */
internal fun PageTexts.author(one: LineComment): String {
    if (one.role == "student") return one.name
    val role = say("staff.role.${one.role}")
    return if (one.name.isEmpty()) role else say("comment.author", one.name, role)
}
