package rasterlab.grader.web

import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.ul
import rasterlab.grader.adjustment.Adjustment
import rasterlab.grader.adjustment.Adjustments
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.regrade.RegradeChoice
import rasterlab.grader.regrade.Regrades
import rasterlab.grader.report.submissionId
import rasterlab.grader.submission.Submission
import rasterlab.grader.submission.Submissions

/** Takes what staff decide on the page of one submission: points given or taken, and, of instructors, grading it again. */
fun Route.markingPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    submissions: Submissions,
    adjustments: Adjustments,
    regrades: Regrades,
    page: ResultPage,
) {
    post("/instructor/submissions/{id}/points") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        val form = call.receiveForm()
        page.showAgain(call, who, form)
        adjustments.give(submission.id, form["points"].orEmpty(), form["reason"].orEmpty(), who.id, key = null)
        call.respondResultPage(submission)
    }
    post("/instructor/submissions/{id}/points/{adjustment}/revoke") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        page.showAgain(call, who, Parameters.Empty)
        adjustments.revoke(submission.id, call.parameters.getOrFail("adjustment"), who.id)
        call.respondResultPage(submission)
    }
    post("/instructor/submissions/{id}/regrade") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val submission = submissions.seenBy(who, call.submissionId())
        page.showAgain(call, who, Parameters.Empty)
        val course = courses.ofStudent(submission.student) ?: throw Rejection.UnknownStudent(submission.student)
        val exercise = exercises.named(submission.exercise)
        val one = listOf(submission.id)
        val begun = regrades.start(course, exercise, RegradeChoice.SOME, one, dry = true, who.id, key = null)
        call.respondRedirect(regradeAddress(begun))
    }
}

private suspend fun ApplicationCall.respondResultPage(submission: Submission) =
    respondRedirect("/submissions/${submission.id}")

/**
 * The forms of staff beside a result.
 *
 * @param mayRegrade whether they may have it graded again
 * @param typed what was refused, or null
 */
internal fun FlowContent.marking(
    texts: PageTexts,
    submission: Submission,
    given: List<Adjustment>,
    mayRegrade: Boolean,
    typed: Parameters?,
) {
    val address = "/instructor/submissions/${submission.id}"
    section("card apart") {
        h2 { +texts.say("points.heading") }
        p { +texts.say("points.about") }
        if (given.isNotEmpty()) ul { given.forEach { one -> li { given(texts, address, one) } } }
        form("$address/points", method = FormMethod.post) {
            label {
                span { +texts.say("points.points") }
                input(InputType.number, name = "points") {
                    value = typed?.get("points").orEmpty()
                    min = "${-Adjustments.MOST}"
                    max = "${Adjustments.MOST}"
                    required = true
                }
            }
            label {
                span { +texts.say("points.reason") }
                input(InputType.text, name = "reason") {
                    value = typed?.get("reason").orEmpty()
                    maxLength = "${Adjustments.MOST_REASON}"
                    required = true
                    attributes["autocomplete"] = "off"
                }
            }
            button { +texts.say("points.do") }
        }
    }
    if (!mayRegrade) return
    section("card apart") {
        h2 { +texts.say("regrade.heading") }
        p { +texts.say("regrade.this") }
        form("$address/regrade", method = FormMethod.post) { button { +texts.say("regrade.try") } }
    }
}

private fun FlowContent.given(
    texts: PageTexts,
    address: String,
    one: Adjustment,
) {
    val points = texts.say("result.manual", signed(one.points), one.reason)
    +texts.say("points.given", points, one.before, texts.time(one.givenAt))
    +" "
    val revoked = one.revokedAt
    if (revoked == null) {
        form("$address/points/${one.id}/revoke", method = FormMethod.post) {
            button(classes = "plain") {
                attributes["aria-label"] = "${texts.say("points.revoke")}: $points"
                +texts.say("points.revoke")
            }
        }
    } else {
        span("earlier") { +texts.say("points.revoked", texts.time(revoked)) }
    }
}
