package rasterlab.grader.hint

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.staff
import rasterlab.grader.course.student
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.language
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text

@Serializable
private data class HintsView(
    val steps: Int,
    val taken: List<HintAnswer>,
    val next: NextView?,
)

@Serializable
private data class HintAnswer(
    val step: Int,
    val cost: Int,
    val text: String,
    val takenAt: String,
)

@Serializable
private data class NextView(
    val step: Int,
    val cost: Int,
)

@Serializable
private data class UseView(
    val student: String,
    val name: String,
    val step: Int,
    val cost: Int,
    val takenAt: String,
)

/**
 * Serves hints to a student and, to the instructor, who was shown which; inside `authenticate`.
 */
fun Route.hints(
    exercises: Exercises,
    hints: Hints,
    courses: Courses,
) {
    get("/exercises/{id}/hints") {
        val student = call.student()
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        call.respondJson(exercise.view(hints.taken(student, exercise), call.language()))
    }
    post("/exercises/{id}/hints") {
        val student = call.student()
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val language = call.language()
        val taken = hints.take(student, exercise, key = call.idempotencyKey())
        call.respondJson(exercise.view(taken, language), Created)
    }
    get("/courses/{course}/exercises/{id}/hints") {
        call.staff()
        val course = call.course(courses)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val all = hints.ofCourse(course.id, exercise.id())
        val part = call.paging(Paging.WHOLE).of(all) { "${it.student}:${it.hint.step}" }
        call.respondPart(
            part.map { UseView(it.student, it.name, it.hint.step, it.hint.cost, it.hint.takenAt.text()) },
        )
    }
}

/** Steps that the exercise has no more are left out; they were paid for in what was handed in then. */
private fun Exercise.view(
    taken: List<TakenHint>,
    language: String,
): HintsView {
    val next = taken.size + 1
    return HintsView(
        hints().size,
        taken.mapNotNull { one ->
            hints().getOrNull(one.step - 1)?.let {
                HintAnswer(one.step, one.cost, it.text(language), one.takenAt.text())
            }
        },
        hints().getOrNull(next - 1)?.let { NextView(next, it.cost()) },
    )
}
