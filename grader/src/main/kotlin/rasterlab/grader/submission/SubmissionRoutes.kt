package rasterlab.grader.submission

import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode.Companion.Accepted
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respond
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.sse.SSEServerContent
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.identity
import rasterlab.grader.course.student
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.report.Results
import rasterlab.grader.report.submissionId

@Serializable
private data class SubmissionAnswer(
    val id: String,
    val state: String,
    val position: Int,
)

/** Inside `authenticate`. */
fun Route.submissions(
    exercises: Exercises,
    intake: Intake,
    queue: GradingQueue,
    results: Results,
    live: Live,
) {
    post("/exercises/{id}/submissions") {
        val student = call.student()
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val accepted = intake.accept(student, exercise, call.receiveSource(), call.idempotencyKey())
        queue.ring(accepted.id)
        call.response.header(HttpHeaders.Location, "/api/v1/submissions/${accepted.id}")
        call.respond(Accepted, SubmissionAnswer(accepted.id, accepted.state.code, accepted.position))
    }
    get("/submissions/{id}/events") {
        val who = call.identity()
        val id = call.submissionId()
        results.view(who, id)
        call.respondEvents { follow(live) { results.view(who, id) } }
    }
}

/** Answers with server-sent events that no cache keeps. */
suspend fun ApplicationCall.respondEvents(send: suspend io.ktor.server.sse.ServerSSESession.() -> Unit) {
    response.header(HttpHeaders.CacheControl, "no-store")
    response.header("X-Accel-Buffering", "no")
    respond(SSEServerContent(this, send))
}
