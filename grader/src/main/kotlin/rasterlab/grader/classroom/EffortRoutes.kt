package rasterlab.grader.classroom

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.staff
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.text

@Serializable
private data class EffortAnswer(
    val student: String,
    val name: String,
    val attempts: Int,
    val best: Int,
    val of: Int,
    val withoutGain: Int,
    val stuck: Boolean,
    val lastAt: String,
    val hints: Int,
    val hintCost: Int,
)

@Serializable
private data class HintEffectAnswer(
    val step: Int,
    val shown: Int,
    val passed: Int,
)

@Serializable
private data class EffortsAnswer(
    val tried: Int,
    val passed: Int,
    val hints: List<HintEffectAnswer>,
    val notPassed: List<EffortAnswer>,
    val next: Int?,
)

/** Serves to staff who never passed an exercise and who is stuck, inside `authenticate`. */
fun Route.efforts(
    courses: Courses,
    exercises: Exercises,
    efforts: Efforts,
) {
    get("/courses/{course}/exercises/{id}/stuck") {
        call.staff()
        val course = call.course(courses)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val from = call.from()
        val found = efforts.of(course.id, exercise.id())
        call.respondJson(
            EffortsAnswer(
                found.efforts.size,
                found.efforts.size - found.open.size,
                found.hints.map { HintEffectAnswer(it.step, it.shown, it.passed) },
                found.open
                    .drop(from)
                    .take(PAGE)
                    .map(::answer),
                nextPage(from, found.open.size),
            ),
        )
    }
}

private fun answer(one: Effort) =
    EffortAnswer(
        one.student,
        one.name,
        one.attempts,
        one.best,
        one.of,
        one.withoutGain,
        one.stuck,
        one.lastAt.text(),
        one.hints,
        one.hintCost,
    )
