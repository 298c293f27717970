package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.form
import kotlinx.html.p
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.worker.WorkerSeen
import rasterlab.grader.worker.WorkerState
import rasterlab.grader.worker.Workers

private const val ADDRESS = "/instructor/workers"

/** Shows an instructor who grades, on which machine and how isolated, and lets them drain one. */
fun Route.workerPages(
    accounts: Accounts,
    workers: Workers,
) {
    get(ADDRESS) { call.respondWorkers(call.instructorHere(accounts), workers.all()) }
    for ((word, drains) in listOf("drain" to true, "resume" to false)) {
        post("$ADDRESS/{worker}/$word") {
            call.requireOwnForm()
            val who = call.instructorHere(accounts)
            workers.drain(call.parameters.getOrFail("worker"), drains, who.id)
            call.respondRedirect(ADDRESS)
        }
    }
}

private suspend fun ApplicationCall.respondWorkers(
    who: Identity.Instructor,
    all: List<WorkerSeen>,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("worker.title")) {
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("worker.about", texts.zoneName) }
        if (all.isEmpty()) p { +texts.say("worker.none") } else workerTable(texts, all)
    }
}

private fun FlowContent.workerTable(
    texts: PageTexts,
    all: List<WorkerSeen>,
) {
    val columns =
        listOf<Pair<String, FlowContent.(WorkerSeen) -> Unit>>(
            "name" to { +it.worker.name },
            "host" to { +it.worker.host },
            "kind" to { +texts.say(if (it.worker.serves) "worker.serves" else "worker.grades") },
            "isolation" to { +it.worker.isolation.`in`(texts.language) },
            "grading" to { +texts.say("worker.load", "${it.grading}", "${it.worker.slots}") },
            "started" to { moment(texts, it.startedAt) },
            "state" to { standing(texts, it) },
        ).map { (name, content) -> texts.say("worker.column.$name", texts.zoneName) to content }
    stacked(texts.say("worker.title"), columns, all)
}

private fun FlowContent.standing(
    texts: PageTexts,
    one: WorkerSeen,
) {
    p { +texts.say("worker.state.${one.state.code}", texts.time(one.seenAt)) }
    if (one.state == WorkerState.LOST) return
    val word = if (one.state == WorkerState.DRAINING) "resume" else "drain"
    form("$ADDRESS/${one.worker.name}/$word", method = FormMethod.post) {
        button(classes = "plain") {
            attributes["aria-label"] = "${texts.say("worker.$word")}: ${one.worker.name}"
            +texts.say("worker.$word")
        }
    }
}
