package rasterlab.grader.web

import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.h3
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import kotlinx.html.unsafe
import rasterlab.exercises.Exercise
import rasterlab.exercises.formula.Formulas
import rasterlab.grader.course.Accounts
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.hint.HintUse
import rasterlab.grader.hint.Hints
import rasterlab.grader.hint.TakenHint
import rasterlab.grader.problem.Rejection

/** The field for the step whose cost was confirmed. */
private const val STEP = "step"

/** Takes a hint by the button that says what it costs. */
fun Route.hintPages(
    accounts: Accounts,
    exercises: Exercises,
    hints: Hints,
) = post("/exercises/{id}/hints") {
    call.requireOwnForm()
    val student = call.studentHere(accounts)
    val exercise = exercises.named(call.parameters.getOrFail("id"))
    val step = call.receiveForm()[STEP]?.toIntOrNull() ?: throw Rejection.Malformed("field '$STEP' must be a number")
    hints.take(student, exercise, step)
    call.respondRedirect("/exercises/${exercise.id()}#hints")
}

/** The steps that were shown, and what the next one costs. */
fun FlowContent.hintSteps(
    texts: PageTexts,
    exercise: Exercise,
    taken: List<TakenHint>,
    formulas: Formulas,
) = section("card hints") {
    id = "hints"
    h2 { +texts.say("hints.title") }
    val all = exercise.hints()
    taken.filter { it.step <= all.size }.forEach { one ->
        h3 { +texts.say("hints.step", one.step, all.size) }
        if (one.cost > 0) p("cost") { +texts.say("hints.paid", one.cost) }
        val html = markdownAsHtml(all[one.step - 1].text(texts.language), formulas, texts.language) { it }
        div { unsafe { +html } }
    }
    val next = taken.size + 1
    if (next > all.size) {
        p("cost") { +texts.say("hints.all") }
    } else {
        val cost = all[next - 1].cost()
        p { +texts.say(if (cost > 0) "hints.cost" else "hints.free", next, all.size, cost) }
        form("/exercises/${exercise.id()}/hints", method = FormMethod.post) {
            input(InputType.hidden, name = STEP) { value = "$next" }
            button { +texts.say("hints.take", next) }
        }
    }
}

/** Who was shown which hints. */
fun FlowContent.hintTable(
    texts: PageTexts,
    exercises: Exercises,
    uses: List<HintUse>,
) = div("scroll") {
    table {
        thead {
            tr {
                listOf("student", "exercise", "hint", "cost", "taken").forEach { column ->
                    val classes = "number".takeIf { column == "hint" || column == "cost" }
                    th(classes = classes) { +texts.say("table.$column", texts.zoneName) }
                }
            }
        }
        tbody {
            uses.forEach { use ->
                tr {
                    td { +use.name }
                    td { +(exercises.find(use.exercise)?.title(texts.language) ?: use.exercise) }
                    td("number") { +"${use.hint.step}" }
                    td("number") { +"${use.hint.cost}" }
                    td { +texts.minute(use.hint.takenAt) }
                }
            }
        }
    }
}
