package rasterlab.grader.web.complaint

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.h2
import kotlinx.html.h3
import kotlinx.html.p
import rasterlab.grader.comment.CommentText
import rasterlab.grader.complaint.ComplaintDesk
import rasterlab.grader.complaint.ListedComplaint
import rasterlab.grader.complaint.accepts
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.ListPart
import rasterlab.grader.problem.Paging
import rasterlab.grader.report.submissionId
import rasterlab.grader.submission.Submissions
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.ResultPage
import rasterlab.grader.web.comment.COMMENT_BYTES
import rasterlab.grader.web.comment.ONCE
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.studentHere
import rasterlab.grader.web.texts

/** Takes complaints on the page of a submission and answers to them, and lists to staff those of a course. */
fun Route.complaintPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    submissions: Submissions,
    complaints: ComplaintDesk,
    page: ResultPage,
) {
    post("/submissions/{id}/complaints") {
        call.requireOwnForm()
        val who = call.studentHere(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        val fields = call.receiveForm(COMMENT_BYTES)
        page.showAgain(call, who, fields)
        val text = CommentText.of(fields["text"].orEmpty())
        val made = complaints.open(who, submission, fields["case"].orEmpty(), text, fields[ONCE])
        call.respondRedirect("/submissions/${submission.id}#complaint-${made.id}")
    }
    post("/submissions/{id}/complaints/{complaint}") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        val fields = call.receiveForm(COMMENT_BYTES)
        page.showAgain(call, who, fields)
        val accepted = accepts(fields["state"].orEmpty())
        val text = CommentText.of(fields["text"].orEmpty())
        val id = call.parameters.getOrFail("complaint")
        complaints.answer(who, submission, id, accepted, text, regrade = fields["regrade"] != null)
        val list = fields[FROM_LIST]?.let(courses::find)
        call.respondRedirect(list?.let(::address) ?: "/submissions/${submission.id}#complaint-$id")
    }
    get("/instructor/courses/{course}/complaints") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val (open, settled) =
            listOf("after" to true, "before" to false).map { (from, waits) ->
                complaints.ofCourse(course.id, waits, Paging(call.request.queryParameters[from]))
            }
        call.respondComplaints(who, course, exercises, open, settled)
    }
}

private fun address(course: Course) = "/instructor/courses/${course.id}/complaints"

private suspend fun ApplicationCall.respondComplaints(
    who: Identity.StaffIdentity,
    course: Course,
    exercises: Exercises,
    open: ListPart<ListedComplaint>,
    settled: ListPart<ListedComplaint>,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("complaints.title", course.name)) {
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("complaints.about") }
        h2 { +texts.say("complaints.open") }
        if (open.items.isEmpty()) p { +texts.say("complaints.none") }
        open.items.forEach { listed(texts, who, course, exercises, it) }
        open.next?.let { p { a("${address(course)}?after=$it") { +texts.say("complaints.later") } } }
        if (settled.items.isNotEmpty()) h2 { +texts.say("complaints.settled") }
        settled.items.forEach { listed(texts, who, course, exercises, it) }
        settled.next?.let { p { a("${address(course)}?before=$it") { +texts.say("complaints.earlier") } } }
    }
}

private fun FlowContent.listed(
    texts: PageTexts,
    who: Identity.StaffIdentity,
    course: Course,
    exercises: Exercises,
    one: ListedComplaint,
) = article("card apart") {
    val exercise = exercises.find(one.exercise)
    val complaint = one.complaint
    h3 {
        a("/submissions/${complaint.submission}#complaint-${complaint.id}") {
            val title = exercise?.title(texts.language) ?: one.exercise
            +texts.say("questions.of", one.student, title, one.attempt)
        }
    }
    p("plan") { +(exercise?.caseTitle(complaint.case, texts.language) ?: complaint.case) }
    complaint(texts, who, complaint, typed = null, course.id)
}
