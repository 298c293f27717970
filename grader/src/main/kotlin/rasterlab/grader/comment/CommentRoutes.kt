package rasterlab.grader.comment

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.json.JsonFields
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.course.course
import rasterlab.grader.course.identity
import rasterlab.grader.course.staff
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submissions

/** A comment as it is answered; students are not told the accounts of staff. */
@Serializable
private data class CommentAnswer(
    val id: String,
    val submission: String,
    val thread: String?,
    val line: Int?,
    val lastLine: Int?,
    val text: String,
    val name: String,
    val role: String,
    val own: Boolean,
    val writtenAt: String,
    val editedAt: String?,
    val open: Boolean,
)

@Serializable
private data class CommentsAnswer(
    val comments: List<CommentAnswer>,
    val next: String?,
)

@Serializable
private data class QuestionAnswer(
    val student: String,
    val exercise: String,
    val attempt: Int,
    val comment: CommentAnswer,
)

@Serializable
private data class QuestionsAnswer(
    val questions: List<QuestionAnswer>,
    val next: String?,
)

@Serializable
private data class KeptAnswer(
    val id: String,
    val name: String,
    val text: String,
    val keptAt: String,
)

/** Serves what is said about a submission to its student and to staff, inside `authenticate`. */
fun Route.comments(
    submissions: Submissions,
    comments: Comments,
) {
    get("/submissions/{id}/comments") {
        val who = call.identity()
        val submission = submissions.seenBy(who, call.parameters.getOrFail("id"))
        val part = comments.part(submission.id, call.paging())
        call.linkNext(part)
        call.respondJson(CommentsAnswer(part.items.map { answer(it, who) }, part.next))
    }
    post("/submissions/{id}/comments") {
        val who = call.identity()
        val submission = submissions.seenBy(who, call.parameters.getOrFail("id"))
        val words = call.receiveJson("text", "line", "lastLine", "thread", read = ::sentWords)
        val key = call.idempotencyKey()
        val made =
            if (words.thread == null) {
                comments.write(who, submission, words.lines, words.text, key)
            } else {
                comments.answer(who, submission, words.thread, words.text, key)
            }
        call.respondJson(answer(made, who), Created)
    }
    patch("/submissions/{id}/comments/{comment}") {
        val who = call.identity()
        val submission = submissions.seenBy(who, call.parameters.getOrFail("id"))
        val text = CommentText.of(call.receiveJson("text") { it.anyText("text") })
        call.respondJson(answer(comments.edit(who, submission, call.commentId(), text), who))
    }
    delete("/submissions/{id}/comments/{comment}") {
        val who = call.identity()
        val submission = submissions.seenBy(who, call.parameters.getOrFail("id"))
        call.respondJson(answer(comments.delete(who, submission, call.commentId()), who))
    }
    post("/submissions/{id}/comments/{comment}/answered") {
        val who = call.identity()
        val submission = submissions.seenBy(who, call.parameters.getOrFail("id"))
        call.respondJson(answer(comments.settle(who, submission, call.commentId()), who))
    }
}

/** Serves to staff the questions of a course that wait, and the comments that it keeps, inside `authenticate`. */
fun Route.courseComments(
    courses: Courses,
    comments: Comments,
    kept: KeptComments,
) {
    get("/courses/{course}/questions") {
        val who = call.staff()
        val part = comments.questions(call.course(courses).id, call.paging())
        call.linkNext(part)
        val questions = part.items.map { QuestionAnswer(it.student, it.exercise, it.attempt, answer(it.comment, who)) }
        call.respondJson(QuestionsAnswer(questions, part.next))
    }
    get("/courses/{course}/kept-comments") {
        call.staff()
        val all = kept.of(call.course(courses).id)
        call.respondPart(call.paging(Paging.WHOLE).of(all) { it.id }.map(::answer))
    }
    post("/courses/{course}/kept-comments") {
        val who = call.staff()
        val course = call.course(courses)
        val (name, text) = call.receiveJson("name", "text") { it.anyText("name") to it.anyText("text") }
        val made = kept.keep(who, course.id, Name.of(name), CommentText.of(text), call.idempotencyKey())
        call.respondJson(answer(made), Created)
    }
    delete("/courses/{course}/kept-comments/{kept}") {
        val who = call.staff()
        call.respondJson(answer(kept.drop(who, call.course(courses).id, call.parameters.getOrFail("kept"))))
    }
}

/** Words about some lines, about the whole submission, or in a thread. */
private class SentWords(
    val text: CommentText,
    val lines: CommentedLines?,
    val thread: String?,
)

private fun sentWords(body: JsonFields): SentWords {
    val thread = if (body.has("thread")) body.anyText("thread") else null
    val first = if (body.has("line")) body.integer("line", 1, Int.MAX_VALUE) else null
    val last = if (body.has("lastLine")) body.integer("lastLine", 1, Int.MAX_VALUE) else first
    if (thread != null && last != null) throw Rejection.BadComment("place")
    return SentWords(CommentText.of(body.anyText("text")), linesAsked(first, last), thread)
}

/**
 * Joins the two ends of a place in a source.
 *
 * @param last null where the first line is all
 * @throws Rejection.BadComment where they are none
 */
internal fun linesAsked(
    first: Int?,
    last: Int?,
): CommentedLines? {
    if (first == null && last == null) return null
    val end = last ?: first
    if (first == null || end == null || first !in 1..end) throw Rejection.BadComment("order", "$first", "$end")
    return CommentedLines(first, end)
}

private fun ApplicationCall.commentId() = parameters.getOrFail("comment")

private fun answer(
    one: LineComment,
    who: Identity,
) = CommentAnswer(
    one.id,
    one.submission,
    one.thread,
    one.lines?.first,
    one.lines?.last,
    one.text,
    one.name,
    one.role,
    one.by == who.id,
    one.writtenAt.text(),
    one.editedAt?.text(),
    one.open,
)

private fun answer(one: ReadyComment) = KeptAnswer(one.id, one.name, one.text, one.keptAt.text())
