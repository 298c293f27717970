package rasterlab.grader.web.lti

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.hiddenInput
import kotlinx.html.li
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.ul
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.lti.BoundContext
import rasterlab.grader.lti.Lti
import rasterlab.grader.lti.ScoreState
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.instructorHere
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts

/** Shows staff which platforms' courses a course is and how the points stand there; an instructor can change that. */
fun Route.scorePages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    lti: Lti,
) {
    get("/instructor/courses/{course}/lti") {
        call.respondScores(call.staffHere(accounts), call.courseOf(courses), exercises, lti)
    }
    post("/instructor/courses/{course}/lti/send") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val course = call.courseOf(courses)
        lti.states.sendNow(course.id, who.id)
        call.respondRedirect("/instructor/courses/${course.id}/lti")
    }
    post("/instructor/courses/{course}/lti/unbind") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val course = call.courseOf(courses)
        val form = call.receiveForm()
        lti.bindings.unbind(course.id, form["platform"].orEmpty(), form["context"].orEmpty(), who.id)
        call.respondRedirect("/instructor/courses/${course.id}/lti")
    }
}

private suspend fun ApplicationCall.respondScores(
    who: Identity.StaffIdentity,
    course: Course,
    exercises: Exercises,
    lti: Lti,
) {
    val texts = texts()
    val states = lti.states.of(course.id)
    val mayChange = who is Identity.Instructor
    respondPage(texts, who, texts.say("lti.course.page", course.name)) {
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("lti.course.page.about", texts.zoneName) }
        section("card apart") {
            h2 { +texts.say("lti.contexts") }
            contexts(texts, course, lti.bindings.contexts(course.id), mayChange)
        }
        h2 { +texts.say("lti.scores") }
        if (states.isEmpty()) {
            p { +texts.say("lti.scores.none") }
        } else {
            p { +texts.say("lti.scores.count", states.count { it.dueAt == null }, states.count { it.dueAt != null }) }
            if (mayChange && states.any { it.fault != null }) {
                form("/instructor/courses/${course.id}/lti/send", classes = "above", method = FormMethod.post) {
                    button { +texts.say("lti.send") }
                }
            }
            scoreTable(texts, exercises, states)
        }
    }
}

private fun FlowContent.contexts(
    texts: PageTexts,
    course: Course,
    all: List<BoundContext>,
    mayChange: Boolean,
) {
    if (all.isEmpty()) return p { +texts.say("lti.contexts.none") }
    ul {
        all.forEach { one ->
            li {
                +"${one.platformName} · ${one.title.ifEmpty { one.context }} "
                if (mayChange) {
                    form("/instructor/courses/${course.id}/lti/unbind", method = FormMethod.post) {
                        hiddenInput(name = "platform") { value = one.platform }
                        hiddenInput(name = "context") { value = one.context }
                        button(classes = "plain") {
                            attributes["aria-label"] = "${texts.say("lti.unbind")}: ${one.title}"
                            +texts.say("lti.unbind")
                        }
                    }
                }
            }
        }
    }
}

private fun FlowContent.scoreTable(
    texts: PageTexts,
    exercises: Exercises,
    states: List<ScoreState>,
) = scrolling(texts.say("lti.scores")) {
    table("students scores") {
        thead {
            tr {
                listOf("student", "exercise", "points", "there", "platform", "state").forEach {
                    th(scope = ThScope.col) { +texts.say("lti.column.$it") }
                }
            }
        }
        tbody {
            states.forEach { one ->
                tr {
                    td { a("/instructor/students/${one.student}") { +one.studentName } }
                    td { +(exercises.find(one.exercise)?.title(texts.language) ?: one.exercise) }
                    td { +points(one.points, one.of) }
                    td { +if (one.sentAt == null) "–" else points(one.sentPoints, one.of) }
                    td { +one.platform }
                    td { +standing(texts, one) }
                }
            }
        }
    }
}

private fun points(
    points: Int?,
    of: Int,
) = if (points == null) "–" else "$points / $of"

private fun standing(
    texts: PageTexts,
    one: ScoreState,
): String {
    val fault = one.fault
    return when {
        one.dueAt == null -> texts.say("lti.state.sent", one.sentAt?.let(texts::minute).orEmpty())
        fault == null -> texts.say("lti.state.waiting")
        fault.all { it.isDigit() } -> texts.say("lti.state.status", fault, texts.minute(one.dueAt))
        else -> texts.say("lti.state.$fault", texts.minute(one.dueAt))
    }
}
