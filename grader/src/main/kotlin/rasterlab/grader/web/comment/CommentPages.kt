package rasterlab.grader.web.comment

import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import rasterlab.grader.comment.CommentText
import rasterlab.grader.comment.CommentedLines
import rasterlab.grader.comment.Comments
import rasterlab.grader.comment.KeptComments
import rasterlab.grader.comment.LineComment
import rasterlab.grader.comment.linesAsked
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.problem.Rejection
import rasterlab.grader.report.submissionId
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.Submissions
import rasterlab.grader.web.ResultPage
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.someone
import rasterlab.grader.web.staffHere

/** The field by which a form that is sent twice is taken once. */
internal const val ONCE = "once"

/** A comment takes up to nine bytes for a character. */
internal const val COMMENT_BYTES = 32 * 1024

/** Takes what the student and staff say on the page of a submission. */
fun Route.commentPages(
    accounts: Accounts,
    courses: Courses,
    submissions: Submissions,
    comments: Comments,
    kept: KeptComments,
    page: ResultPage,
) {
    /** Does it with the form that was sent, and shows the page; where it is refused, with what was typed. */
    fun form(
        path: String,
        act: (SentForm) -> String,
    ) = post("/submissions/{id}/comments$path") {
        call.requireOwnForm()
        val who = call.someone(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        val fields = call.receiveForm(COMMENT_BYTES)
        page.showAgain(call, who, fields)
        val thread = act(SentForm(call, who, submission, fields))
        call.respondRedirect("/submissions/${submission.id}#$thread")
    }
    form("") { sent ->
        val text = sent.words(courses, kept)
        place(comments.write(sent.who, sent.submission, sent.lines(), text, sent.fields[ONCE]))
    }
    form("/{comment}/answer") { sent ->
        val text = sent.words(courses, kept)
        place(comments.answer(sent.who, sent.submission, sent.comment, text, sent.fields[ONCE]))
    }
    form("/{comment}/edit") { sent ->
        val text = CommentText.of(sent.fields["text"].orEmpty())
        place(comments.edit(sent.who, sent.submission, sent.comment, text))
    }
    form("/{comment}/delete") { sent ->
        comments.delete(sent.who, sent.submission, sent.comment)
        "handed"
    }
    form("/{comment}/answered") { sent -> place(comments.settle(sent.who, sent.submission, sent.comment)) }
    form("/{comment}/keep") { sent ->
        val who = sent.call.staffHere(accounts)
        val one = comments.find(sent.submission, sent.comment)
        val name = Name.of(sent.fields["name"].orEmpty())
        kept.keep(who, sent.course(courses), name, CommentText.of(one.text), sent.fields[ONCE])
        place(one)
    }
}

private fun place(one: LineComment) = "comment-${one.thread ?: one.id}"

/** A form of the page of [submission], as [who] sent it. */
private class SentForm(
    val call: ApplicationCall,
    val who: Identity,
    val submission: Submission,
    val fields: Parameters,
) {
    val comment get() = call.parameters.getOrFail("comment")

    fun course(courses: Courses): String =
        courses.ofStudent(submission.student)?.id ?: throw Rejection.UnknownStudent(submission.student)

    /** Joins what was typed, of staff behind the kept comment that they chose. */
    fun words(
        courses: Courses,
        kept: KeptComments,
    ): CommentText {
        val chosen = fields["kept"].orEmpty().takeIf { it.isNotEmpty() && who is Identity.StaffIdentity }
        val begun = chosen?.let { kept.find(course(courses), it).text }
        return CommentText.of(listOfNotNull(begun, fields["text"]).filter { it.isNotBlank() }.joinToString("\n\n"))
    }

    fun lines(): CommentedLines? {
        val (first, last) = listOf("line", "last").map { fields[it].orEmpty().trim() }
        if (first.isEmpty() && last.isEmpty()) return null
        val numbers = listOf(first, last.ifEmpty { first }).map { it.toIntOrNull() }
        if (null in numbers) throw Rejection.BadComment("order", first, last)
        return linesAsked(numbers[0], numbers[1])
    }
}
