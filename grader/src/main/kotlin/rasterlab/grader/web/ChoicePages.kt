package rasterlab.grader.web

import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.label
import kotlinx.html.option
import kotlinx.html.select
import kotlinx.html.span
import rasterlab.grader.course.Accounts
import rasterlab.grader.submission.Choices
import rasterlab.grader.submission.Listed

/** Takes from a page which attempt a student wants to count. */
fun Route.choicePages(
    accounts: Accounts,
    choices: Choices,
) = post("/chosen") {
    call.requireOwnForm()
    val student = call.studentHere(accounts)
    val chosen = choices.choose(student, call.receiveForm()["submission"].orEmpty())
    call.respondRedirect("/exercises/${chosen.exercise}")
}

/** Asks which attempt counts. */
internal fun FlowContent.choice(
    texts: PageTexts,
    attempts: List<Listed>,
) = form("/chosen", method = FormMethod.post) {
    label {
        span { +texts.say("exercise.choose") }
        select {
            name = "submission"
            attempts.forEach { one ->
                option {
                    value = one.submission.id
                    selected = one.chosen
                    +texts.say("table.attempt.number", one.submission.attempt)
                }
            }
        }
    }
    button { +texts.say("exercise.choose.do") }
}
