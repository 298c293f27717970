package rasterlab.grader.web.classroom

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import kotlinx.html.FlowContent
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.h2
import kotlinx.html.p
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.exercises.Exercise
import rasterlab.grader.classroom.ClassEfforts
import rasterlab.grader.classroom.Effort
import rasterlab.grader.classroom.Efforts
import rasterlab.grader.classroom.HintEffect
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.exerciseOf
import rasterlab.grader.web.moment
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.rulesAddress
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts

/** Shows staff who is stuck at an exercise, and what hints do. */
fun Route.effortPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    efforts: Efforts,
) {
    get("/instructor/courses/{course}/exercises/{id}/stuck") {
        val who = call.staffHere(accounts)
        val course = call.courseOf(courses)
        val exercise = call.exerciseOf(exercises)
        call.respondEfforts(who, course, exercise, efforts.of(course.id, exercise.id()))
    }
}

/** The ways between the pages on one class and exercise. */
internal fun FlowContent.waysOfClass(
    texts: PageTexts,
    course: Course,
    exercise: Exercise,
    here: String,
) = p("ways") {
    a("/instructor/courses/${course.id}/exercises") { +texts.say("rules.back") }
    val isWritten = exercise.form() == Exercise.TaskKind.WRITE
    CLASS_PAGES.filter { it != here && (isWritten || it !in OF_PROGRAMS) }.forEach { page ->
        a("${rulesAddress(course, exercise)}/$page") { +texts.say("$page.heading") }
    }
}

private val CLASS_PAGES = listOf("errors", "stuck", "front", "similarity")

/** Pages that only exercises have for which programs are written. */
private val OF_PROGRAMS = setOf("front", "similarity")

private suspend fun ApplicationCall.respondEfforts(
    who: Identity.StaffIdentity,
    course: Course,
    exercise: Exercise,
    found: ClassEfforts,
) {
    val texts = texts()
    val heading = "${texts.say("stuck.heading")}: ${exercise.title(texts.language)} — ${course.name}"
    respondPage(texts, who, heading) {
        waysOfClass(texts, course, exercise, "stuck")
        p("plan") { +texts.say("stuck.about", Effort.STUCK) }
        p { +texts.say("stuck.count", found.efforts.size, found.efforts.size - found.open.size) }
        h2 { +texts.say("stuck.open") }
        if (found.open.isEmpty()) p { +texts.say("stuck.none") } else effortTable(texts, found.open)
        if (found.hints.isNotEmpty()) {
            h2 { +texts.say("stuck.hints") }
            hintEffects(texts, found.hints)
        }
    }
}

private fun FlowContent.effortTable(
    texts: PageTexts,
    open: List<Effort>,
) = scrolling(texts.say("stuck.open")) {
    table("students") {
        thead {
            tr {
                th(scope = ThScope.col) { +texts.say("table.student") }
                listOf("attempts", "withoutGain", "best", "hints").forEach {
                    th(scope = ThScope.col, classes = "number") { +texts.say("stuck.$it") }
                }
                th(scope = ThScope.col) { +texts.say("stuck.last", texts.zoneName) }
            }
        }
        tbody {
            open.forEach { one ->
                tr {
                    td {
                        a("/instructor/students/${one.student}") { +one.name }
                        if (one.stuck) span("loses") { +texts.say("stuck.stuck") }
                    }
                    listOf("${one.attempts}", "${one.withoutGain}", "${one.best} / ${one.of}", "${one.hints}").forEach {
                        td("number") { +it }
                    }
                    td { moment(texts, one.lastAt) }
                }
            }
        }
    }
}

private fun FlowContent.hintEffects(
    texts: PageTexts,
    hints: List<HintEffect>,
) = scrolling(texts.say("stuck.hints")) {
    table {
        thead {
            tr {
                listOf(
                    "step",
                    "shown",
                    "passed",
                ).forEach { th(scope = ThScope.col) { +texts.say("stuck.hint.$it") } }
            }
        }
        tbody {
            hints.forEach { one ->
                tr { listOf(one.step, one.shown, one.passed).forEach { td { +"$it" } } }
            }
        }
    }
}
