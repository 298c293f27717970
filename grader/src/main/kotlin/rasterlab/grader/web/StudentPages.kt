package rasterlab.grader.web

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondRedirect
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.serialization.json.Json
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.student.KeptStudent
import rasterlab.grader.student.StudentRecords
import rasterlab.grader.student.respondZip
import rasterlab.grader.submission.Submissions
import java.time.Instant

/** Shows staff one student and what they handed in; an instructor their access, data to take away, and deletion too. */
fun Route.studentPages(
    accounts: Accounts,
    exercises: Exercises,
    submissions: Submissions,
    records: StudentRecords,
) {
    get("/instructor/students/{student}") {
        val who = call.staffHere(accounts)
        val kept = records.look(call.studentAsked())
        call.respondStudent(who, kept, accounts.revokedSince(kept.student), exercises, submissions)
    }
    get("/instructor/students/{student}/data.json") {
        val kept = records.export(call.studentAsked(), call.instructorHere(accounts).id)
        call.response.header(HttpHeaders.ContentDisposition, "attachment; filename=\"student-${kept.number}.json\"")
        call.respondText(Json.encodeToString(kept), ContentType.Application.Json)
    }
    get("/instructor/students/{student}/data.zip") {
        call.respondZip(records.export(call.studentAsked(), call.instructorHere(accounts).id), exercises::ending)
    }
    post("/instructor/students/{student}/delete") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        if (call.receiveForm()["sure"] != "yes") throw Rejection.Malformed("the form's field 'sure' must be 'yes'")
        val gone = records.delete(call.studentAsked(), who.id)
        call.respondRedirect("/instructor/courses/${gone.course}/students")
    }
}

private fun ApplicationCall.studentAsked() = parameters.getOrFail("student")

private suspend fun ApplicationCall.respondStudent(
    who: Identity.StaffIdentity,
    kept: KeptStudent,
    revokedSince: Instant?,
    exercises: Exercises,
    submissions: Submissions,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("student.title", kept.shownName)) {
        p { a("/instructor/courses/${kept.course}/students") { +texts.say("roster.back") } }
        p("plan") { +texts.say("student.about", kept.number, kept.joinedAt.take(DAY_LENGTH)) }
        val rows = submissions.allOf(kept.student)
        if (rows.isEmpty()) p { +texts.say("exercise.mine.none") } else classTable(texts, exercises, rows)
        section("card apart") {
            h2 { +texts.say("view.heading") }
            p { +texts.say("view.about") }
            viewButton(texts, kept.student, submission = null)
        }
        if (who is Identity.Instructor) {
            section("card apart") { access(texts, kept, revokedSince) }
            section("card apart") {
                h2 { +texts.say("student.data") }
                p { +texts.say("student.data.about") }
                p("ways") {
                    a("/instructor/students/${kept.student}/data.zip") { +"ZIP" }
                    a("/instructor/students/${kept.student}/data.json") { +"JSON" }
                }
            }
            section("card apart") { deletion(texts, kept) }
        }
    }
}

private fun FlowContent.access(
    texts: PageTexts,
    kept: KeptStudent,
    revokedSince: Instant?,
) {
    val address = "/instructor/students/${kept.student}"
    h2 { +texts.say("student.access") }
    if (revokedSince == null) {
        p { +texts.say("student.access.about") }
    } else {
        p { +texts.say("student.access.none", texts.time(revokedSince)) }
    }
    div("ways") {
        newTokenButton(texts, "$address/token", kept.shownName)
        if (revokedSince == null) {
            form("$address/revoke", method = FormMethod.post) {
                button(classes = "plain") { +texts.say("student.access.revoke") }
            }
        }
    }
}

/**
 * Gives staff the view of a student.
 *
 * @param submission on whose page it begins; null for the page of the exercises
 */
internal fun FlowContent.viewButton(
    texts: PageTexts,
    student: String,
    submission: String?,
) = form("/instructor/students/$student/view", method = FormMethod.post) {
    submission?.let { input(InputType.hidden, name = "submission") { value = it } }
    button(classes = "plain") { +texts.say(if (submission == null) "view.do" else "view.do.here") }
}

private const val DAY_LENGTH = 10

private fun FlowContent.deletion(
    texts: PageTexts,
    kept: KeptStudent,
) {
    h2 { +texts.say("student.delete") }
    p { +texts.say("student.delete.about") }
    form("/instructor/students/${kept.student}/delete", method = FormMethod.post) {
        label("consent") {
            input(InputType.checkBox, name = "sure") {
                value = "yes"
                required = true
            }
            span { +texts.say("student.delete.sure", kept.shownName) }
        }
        button { +texts.say("student.delete.do") }
    }
}
