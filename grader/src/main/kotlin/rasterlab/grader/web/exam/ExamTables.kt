package rasterlab.grader.web.exam

import io.ktor.server.application.ApplicationCall
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.TR
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.p
import kotlinx.html.summary
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.grader.course.Identity
import rasterlab.grader.exam.Exam
import rasterlab.grader.exam.ExamEvent
import rasterlab.grader.exam.SeatedStudent
import rasterlab.grader.exam.SittingState
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.rules.said
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.texts
import rasterlab.grader.web.unbrokenTimes
import java.time.Instant

/** The page of one exam: who works on it, and its protocol. */
internal suspend fun ApplicationCall.respondExam(
    who: Identity.StaffIdentity,
    exam: Exam,
    seats: List<SeatedStudent>,
    events: List<ExamEvent>,
    now: Instant,
    exercises: Exercises,
) {
    val texts = texts()
    respondPage(texts, who, exam.name) {
        p("ways") {
            a("/instructor/courses/${exam.course}/exams") { +texts.say("exams.back") }
            if (who is Identity.Instructor) {
                a("/instructor/exams/${exam.id}/protocol.csv") { +texts.say("exams.protocol.csv") }
                a("/instructor/exams/${exam.id}/change") { +texts.say("exams.change") }
            }
        }
        p { unbrokenTimes(texts.said(exam)) }
        exam.repeatedHours().said(texts.language).forEach { p("plan") { +it } }
        p { +exam.exercises.joinToString { exercises.find(it)?.title(texts.language) ?: it } }
        val from = exam.addresses.text
        p { +if (from.isEmpty()) texts.say("exams.from.any") else texts.say("exams.from", from) }
        h2 { +texts.say("exams.students") }
        scrolling(texts.say("exams.students")) { students(texts, who, exam, seats, now) }
        if (who is Identity.Instructor && seats.any { it.sitting.state(now) == SittingState.RUNNING }) end(texts, exam)
        h2 { +texts.say("exams.protocol") }
        if (events.isEmpty()) p { +texts.say("exams.protocol.none") }
        if (events.isNotEmpty()) scrolling(texts.say("exams.protocol")) { protocol(texts, exam, events) }
        if (who is Identity.Instructor && seats.all { it.sitting.started == null }) drop(texts, exam)
    }
}

private fun FlowContent.end(
    texts: PageTexts,
    exam: Exam,
) = details("card exam") {
    summary { +texts.say("exams.end") }
    p { +texts.say("exams.end.about") }
    form("/instructor/exams/${exam.id}/end", method = FormMethod.post) { button { +texts.say("exams.end.do") } }
}

private fun FlowContent.drop(
    texts: PageTexts,
    exam: Exam,
) = details("card exam") {
    summary { +texts.say("exams.drop") }
    p { +texts.say("exams.drop.about") }
    form("/instructor/exams/${exam.id}/drop", method = FormMethod.post) { button { +texts.say("exams.drop.do") } }
}

private fun FlowContent.columns(
    texts: PageTexts,
    keys: List<String>,
    rows: kotlinx.html.TBODY.() -> Unit,
) = table {
    thead { tr { keys.forEach { th(scope = ThScope.col) { +texts.say("exams.$it", texts.zoneName) } } } }
    tbody { rows() }
}

private fun FlowContent.students(
    texts: PageTexts,
    who: Identity.StaffIdentity,
    exam: Exam,
    seats: List<SeatedStudent>,
    now: Instant,
) = columns(texts, listOf("student", "state", "ends", "from.address", "extra", "release")) {
    seats.forEach { seat ->
        val sitting = seat.sitting
        tr {
            td { +seat.name }
            td { +texts.say("exams.state.${sitting.state(now).code}") }
            td { +sitting.ends?.let { texts.second(it) }.orEmpty() }
            td { +sitting.address.orEmpty() }
            td { if (who is Identity.Instructor) extra(texts, exam, seat) else +"${sitting.extra}" }
            td { if (sitting.session != null && sitting.ended == null) release(texts, exam, seat) }
        }
    }
}

private fun FlowContent.extra(
    texts: PageTexts,
    exam: Exam,
    seat: SeatedStudent,
) = form("/instructor/exams/${exam.id}/students/${seat.sitting.student}/extra", method = FormMethod.post) {
    div("ways minutes") {
        input(InputType.number, name = "extra") {
            value = "${seat.sitting.extra}"
            min = "${Exam.EXTRA.first}"
            max = "${Exam.EXTRA.last}"
            attributes["aria-label"] = "${texts.say("exams.extra")}: ${seat.name}"
        }
        button(classes = "plain") {
            attributes["aria-label"] = "${texts.say("exams.extra.do")}: ${seat.name}"
            +texts.say("exams.extra.do")
        }
    }
}

private fun FlowContent.release(
    texts: PageTexts,
    exam: Exam,
    seat: SeatedStudent,
) = form("/instructor/exams/${exam.id}/students/${seat.sitting.student}/release", method = FormMethod.post) {
    button(classes = "plain") {
        attributes["aria-label"] = "${texts.say("exams.release.do")}: ${seat.name}"
        +texts.say("exams.release.do")
    }
}

private fun FlowContent.protocol(
    texts: PageTexts,
    exam: Exam,
    events: List<ExamEvent>,
) = columns(texts, listOf("time", "student", "event", "from.address", "detail")) {
    events.forEach { event ->
        tr {
            td { +texts.second(event.at) }
            td { +event.name }
            td { +texts.say("exams.event.${event.kind}") }
            td { +event.address }
            detail(event)
        }
    }
}

private fun TR.detail(event: ExamEvent) =
    td {
        val submission = event.detail.substringAfterLast(' ').takeIf { event.kind == "hand-in" }
        if (submission == null) +event.detail else a("/submissions/$submission") { +event.detail.substringBefore(' ') }
    }
