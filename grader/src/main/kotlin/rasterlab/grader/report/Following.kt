package rasterlab.grader.report

import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respond
import io.ktor.server.sse.SSEServerContent
import io.ktor.server.sse.ServerSSESession
import io.ktor.sse.ServerSentEvent
import kotlinx.coroutines.withTimeoutOrNull
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import rasterlab.grader.submission.Live

@Serializable
private data class PositionEvent(
    val position: Int,
    val state: String,
)

private const val QUIET_MILLIS = 15_000L

/**
 * Reports a submission's progress: `position` whenever it changes, `case` for each judged case (the event's
 * id is its place from 0), `done` with the whole submission. A client that connects again gets it all again.
 */
suspend fun ServerSSESession.follow(
    live: Live,
    submission: String,
    look: () -> SubmissionView,
) {
    var place: PositionEvent? = null
    var told = 0
    onEachChange(live, submission) {
        val now = look()
        val newPlace = PositionEvent(now.position, now.state)
        if (newPlace != place && now.verdict == null) send(Json.encodeToString(newPlace), event = "position")
        place = newPlace
        if (now.cases.size < told) told = 0
        now.cases.drop(told).forEachIndexed { index, case ->
            send(Json.encodeToString(CaseAsPublished, case), event = "case", id = (told + index).toString())
        }
        told = now.cases.size
        if (now.verdict != null) send(Json.encodeToString(now), event = "done")
        now.verdict == null
    }
}

/**
 * Calls [tell] now and after each change, until it returns false; keeps a quiet connection alive.
 *
 * @param submission the one that is watched, or null for all
 */
suspend fun ServerSSESession.onEachChange(
    live: Live,
    submission: String?,
    tell: suspend () -> Boolean,
) {
    while (true) {
        // The stand is read before looking: a change during the look makes us look again.
        val seen = live.stand(submission)
        if (!tell()) return
        while (withTimeoutOrNull(QUIET_MILLIS) { live.awaitChange(submission, seen) } == null) {
            send(ServerSentEvent(comments = "nothing new"))
        }
    }
}

/** Answers with server-sent events that no cache keeps. */
suspend fun ApplicationCall.respondEvents(send: suspend ServerSSESession.() -> Unit) {
    response.header(HttpHeaders.CacheControl, "no-store")
    response.header("X-Accel-Buffering", "no")
    respond(SSEServerContent(this, send))
}
