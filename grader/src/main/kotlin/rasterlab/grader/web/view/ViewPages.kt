// The pages as a student has them, for staff. Start with ViewPages; what it means for each page stands in Session.
package rasterlab.grader.web.view

import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.course.viewedStudent
import rasterlab.grader.problem.Rejection
import rasterlab.grader.submission.Submissions
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.viewAs

/** Lets staff see the pages as a student has them, and leads them back. */
fun Route.viewPages(
    accounts: Accounts,
    submissions: Submissions,
) {
    post("/instructor/students/{student}/view") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val id = call.parameters.getOrFail("student")
        val student = accounts.withId(id) as? Identity.StudentIdentity ?: throw Rejection.UnknownStudent(id)
        val page = call.receiveForm()["submission"]?.let(submissions::find)?.takeIf { it.student == id }
        accounts.noteView(student, who.id)
        call.viewAs(id)
        call.respondRedirect(page?.let { "/submissions/${it.id}" } ?: "/exercises")
    }
    post("/instructor/view/end") {
        call.requireOwnForm()
        val viewed = call.viewedStudent(accounts, call.staffHere(accounts))
        call.viewAs("")
        call.respondRedirect(viewed?.let { "/instructor/students/${it.id}" } ?: "/instructor")
    }
}
