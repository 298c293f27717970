package rasterlab.grader.web.comment

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.p
import kotlinx.html.section
import rasterlab.grader.comment.CommentText
import rasterlab.grader.comment.Comments
import rasterlab.grader.comment.KeptComments
import rasterlab.grader.comment.OpenQuestion
import rasterlab.grader.comment.ReadyComment
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.storage.Secrets
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.place
import rasterlab.grader.web.problem
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts

/** Shows staff the questions of a course that wait for an answer, and the comments that it keeps. */
fun Route.questionPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    comments: Comments,
    kept: KeptComments,
) {
    get("/instructor/courses/{course}/questions") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val part = comments.questions(course.id, Paging(call.request.queryParameters[Paging.AFTER]))
        call.respondQuestions(who, course, exercises, part)
    }
    get("/instructor/courses/{course}/kept-comments") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        call.respondKept(who, course, kept.of(course.id), typed = null, HttpStatusCode.OK) {}
    }
    post("/instructor/courses/{course}/kept-comments") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val fields = call.receiveForm(COMMENT_BYTES)
        call.attributes.put(
            FORM_AGAIN,
            FormAgain { status, code, added ->
                call.respondKept(who, course, kept.of(course.id), fields, status) {
                    problem(call.texts(), status, code, added(call.texts().language))
                }
            },
        )
        val text = CommentText.of(fields["text"].orEmpty())
        kept.keep(who, course.id, Name.of(fields["name"].orEmpty()), text, fields[ONCE])
        call.respondRedirect("/instructor/courses/${course.id}/kept-comments")
    }
    post("/instructor/courses/{course}/kept-comments/{kept}/drop") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        kept.drop(who, course.id, call.parameters.getOrFail("kept"))
        call.respondRedirect("/instructor/courses/${course.id}/kept-comments")
    }
}

private suspend fun ApplicationCall.respondQuestions(
    who: Identity.StaffIdentity,
    course: Course,
    exercises: Exercises,
    part: ListPart<OpenQuestion>,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("questions.title", course.name)) {
        p("ways") {
            a("/instructor") { +texts.say("token.back") }
            a("/instructor/courses/${course.id}/kept-comments") { +texts.say("kept.open") }
        }
        p("plan") { +texts.say("questions.about") }
        if (part.items.isEmpty()) p { +texts.say("questions.none") }
        part.items.forEach { question(texts, exercises, it) }
        part.next?.let {
            p {
                a(
                    "/instructor/courses/${course.id}/questions?after=$it",
                ) { +texts.say("questions.later") }
            }
        }
    }
}

private fun FlowContent.question(
    texts: PageTexts,
    exercises: Exercises,
    one: OpenQuestion,
) = article("card apart") {
    val title = exercises.find(one.exercise)?.title(texts.language) ?: one.exercise
    h2 {
        a("/submissions/${one.comment.submission}#comment-${one.comment.id}") {
            +texts.say("questions.of", one.student, title, one.attempt)
        }
    }
    p("plan") {
        +"${texts.place(one.comment.lines)} · ${texts.say("comment.at", texts.time(one.comment.writtenAt))}"
    }
    p("words") { +one.comment.text }
}

private suspend fun ApplicationCall.respondKept(
    who: Identity.StaffIdentity,
    course: Course,
    kept: List<ReadyComment>,
    typed: Parameters?,
    status: HttpStatusCode,
    trouble: FlowContent.() -> Unit,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("kept.title", course.name), status) {
        trouble()
        p { a("/instructor/courses/${course.id}/questions") { +texts.say("kept.back") } }
        p("plan") { +texts.say("kept.about") }
        if (kept.isEmpty()) p { +texts.say("kept.none") }
        val address = "/instructor/courses/${course.id}/kept-comments"
        kept.forEach { one ->
            article("card apart") {
                h2 { +one.name }
                p("words") { +one.text }
                form("$address/${one.id}/drop", method = FormMethod.post) {
                    button(classes = "plain") {
                        attributes["aria-label"] = "${texts.say("kept.drop")}: ${one.name}"
                        +texts.say("kept.drop")
                    }
                }
            }
        }
        section("card apart") {
            h2 { +texts.say("kept.new") }
            form(address, method = FormMethod.post) {
                input(InputType.hidden, name = ONCE) { value = Secrets.newId() }
                keptName(texts, typed?.get("name").orEmpty())
                wordsField(texts.say("comment.text"), typed?.get("text").orEmpty())
                button { +texts.say("comment.keep.do") }
            }
        }
    }
}
