package rasterlab.grader.web

import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode.Companion.ServiceUnavailable
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import rasterlab.exercises.runner.Isolation
import rasterlab.grader.metrics.Meters
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.language
import rasterlab.grader.problem.respondProblem
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.WriteTrial

/** Serves the machines that watch the server; nothing here names a person. */
fun Route.monitoring(
    database: Database,
    isolation: () -> Isolation,
    meters: Meters,
) {
    val trial = WriteTrial(database)
    get("/healthz") { call.respondText("ok\n") }
    get("/readyz") {
        if (!database.hasRoom()) throw Rejection.NoRoom()
        trial.require()
        call.respondText(ready(isolation(), call.language()))
    }
    get("/metrics") { call.respondText(meters.text(), PROMETHEUS_TEXT) }
}

/**
 * A word for machines, then what people want to know before they trust the results. The keys are for machines too, and
 * English in every language; what is missing is for people.
 */
private fun ready(
    isolation: Isolation,
    language: String,
) = buildString {
    appendLine("ready")
    appendLine("isolation: ${isolation.name()}")
    isolation.missing().forEach { appendLine("missing: ${it.`in`(language)}") }
    appendLine("exam: ${if (isolation.exam()) "yes" else "no"}")
}

private val PROMETHEUS_TEXT = ContentType.parse("text/plain; version=0.0.4; charset=utf-8")
