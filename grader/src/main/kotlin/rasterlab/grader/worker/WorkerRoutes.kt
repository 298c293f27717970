package rasterlab.grader.worker

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.instructor
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text

@Serializable
private data class WorkerAnswer(
    val worker: String,
    val host: String,
    val serves: Boolean,
    val isolation: String,
    val slots: Int,
    val grading: Int,
    val state: String,
    val startedAt: String,
    val seenAt: String,
)

/** Serves who grades to instructors, inside `authenticate`, and lets them drain one. */
fun Route.workers(workers: Workers) {
    get("/workers") {
        call.instructor()
        call.respondPart(call.paging(Paging.WHOLE).of(workers.all()) { it.worker.name }.map(::answer))
    }
    for ((word, drains) in listOf("drain" to true, "resume" to false)) {
        post("/workers/{worker}/$word") {
            val instructor = call.instructor()
            call.respondJson(answer(workers.drain(call.parameters.getOrFail("worker"), drains, instructor.id)))
        }
    }
}

private fun answer(one: WorkerSeen) =
    WorkerAnswer(
        one.worker.name,
        one.worker.host,
        one.worker.serves,
        one.worker.isolation.`in`("en"),
        one.worker.slots,
        one.grading,
        one.state.code,
        one.startedAt.text(),
        one.seenAt.text(),
    )
