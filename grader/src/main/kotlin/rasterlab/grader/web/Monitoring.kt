package rasterlab.grader.web

import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode.Companion.ServiceUnavailable
import io.ktor.server.response.respondBytes
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.respondProblem
import rasterlab.grader.storage.Database

/** For the machines that watch the server; nothing here names a person. */
fun Route.monitoring(database: Database) {
    get("/healthz") { call.respondText("ok\n") }
    get("/readyz") {
        if (!database.hasRoom()) throw Rejection.NoRoom()
        database.write { it.execute("UPDATE secrets SET name = name WHERE 0") }
        call.respondText("ready\n")
    }
    get(
        "/metrics",
    ) { call.respondText(metrics(database), ContentType.parse("text/plain; version=0.0.4; charset=utf-8")) }
    get("/openapi.json") { call.respondBytes(openApi, ContentType.Application.Json) }
}

private val openApi by lazy { Monitoring.resource("openapi.json") }

private object Monitoring {
    fun resource(name: String): ByteArray =
        checkNotNull(javaClass.getResourceAsStream(name)) { "$name is missing from the program" }.use { it.readBytes() }
}

/** Counts in the Prometheus text format. */
private fun metrics(database: Database): String {
    fun counts(sql: String) =
        database.read { handle ->
            handle
                .createQuery(sql)
                .map { row, _ ->
                    row.getString(1) to
                        row.getLong(2)
                }.list()
        }
    return buildString {
        appendLine("# TYPE rasterlab_submissions gauge")
        counts("SELECT state, count(*) FROM submissions GROUP BY state").forEach { (state, count) ->
            appendLine("rasterlab_submissions{state=\"$state\"} $count")
        }
        appendLine("# TYPE rasterlab_results_total counter")
        counts("SELECT verdict, count(*) FROM results GROUP BY verdict").forEach { (verdict, count) ->
            appendLine("rasterlab_results_total{verdict=\"$verdict\"} $count")
        }
        appendLine("# TYPE rasterlab_oldest_waiting_seconds gauge")
        counts(
            """SELECT 'age', coalesce(max(unixepoch() - unixepoch(received_at)), 0) FROM submissions WHERE state = 'queued'""",
        ).forEach { (_, seconds) -> appendLine("rasterlab_oldest_waiting_seconds $seconds") }
        val heap = Runtime.getRuntime().run { totalMemory() - freeMemory() }
        appendLine("# TYPE rasterlab_heap_bytes gauge")
        appendLine("rasterlab_heap_bytes $heap")
    }
}
