package rasterlab.grader.submission

import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode.Companion.Accepted
import io.ktor.server.response.header
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import io.ktor.server.routing.put
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.student
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.limits.tell
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.respondJson

@Serializable
private data class ChoiceAnswer(
    val id: String,
    val exercise: String,
    val attempt: Int,
)

@Serializable
private data class SubmissionAnswer(
    val id: String,
    val state: String,
    val position: Int,
)

/** Says in an address or a form that a submission may be marked as late. */
const val LATE = "late"

const val ACCEPT = "accept"

/** Serves submissions, inside `authenticate`. */
fun Route.submissions(
    exercises: Exercises,
    intake: Intake,
    queue: GradingQueue,
    choices: Choices,
) {
    post("/exercises/{id}/submissions") {
        val student = call.student()
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val source = call.receiveSource(exercise.form())
        val late = call.request.rawQueryParameters[LATE] == ACCEPT
        val accepted = intake.accept(student, exercise, source, call.idempotencyKey(), late)
        queue.ring(accepted.id)
        call.tell(accepted.allowance)
        call.response.header(HttpHeaders.Location, "/api/v1/submissions/${accepted.id}")
        call.respondJson(SubmissionAnswer(accepted.id, accepted.state.code, accepted.position), Accepted)
    }
    put("/submissions/{id}/chosen") {
        val chosen = choices.choose(call.student(), call.parameters.getOrFail("id"))
        call.respondJson(ChoiceAnswer(chosen.id, chosen.exercise, chosen.attempt))
    }
}
