package rasterlab.grader.classroom

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.put
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.engine.Topics
import rasterlab.exercises.Exercise
import rasterlab.exercises.score.SpeedPoints
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.staff
import rasterlab.grader.course.student
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.similarity.written
import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode

/** @param named whether the class reads the name of whoever asks on its charts */
@Serializable
private data class FrontNameAnswer(
    val named: Boolean,
)

/** @param name of a student who wants it to be read; null of all others */
@Serializable
private data class PlaceAnswer(
    val ratio: Double,
    val low: Double,
    val high: Double,
    val error: Double?,
    val own: Boolean,
    val name: String?,
)

@Serializable
private data class NamedPlaceAnswer(
    val student: String,
    val name: String,
    val submission: String,
    val ratio: Double,
    val low: Double,
    val high: Double,
    val error: Double?,
)

@Serializable
private data class FrontAnswer<T>(
    val item: String,
    val errorUnit: String,
    val fullUpTo: Double,
    val least: Int,
    val points: List<T>,
)

/** Serves the speeds and errors of a class, inside `authenticate`: to students without names, to staff with them. */
fun Route.fronts(
    courses: Courses,
    exercises: Exercises,
    front: ClassFront,
) {
    get("/exercises/{id}/front") {
        val student = call.student()
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        val places = front.seenBy(student.id, courses.ofStudent(student.id)?.id.orEmpty(), exercise)
        call.respondJson(
            answer(exercise, places) {
                PlaceAnswer(
                    it.median,
                    it.low,
                    it.high,
                    it.error,
                    it.student == student.id,
                    it.name.takeIf { _ ->
                        it.named
                    },
                )
            },
        )
    }
    get("/front-name") { call.respondJson(FrontNameAnswer(front.names(call.student().id))) }
    put("/front-name") {
        val student = call.student()
        val named =
            call.receiveJson("named") {
                if (!it.has("named")) throw Rejection.Malformed("the body: named is missing")
                it.flag("named", false)
            }
        front.name(student.id, named)
        call.respondJson(FrontNameAnswer(front.names(student.id)))
    }
    get("/courses/{course}/exercises/{id}/front") {
        call.staff()
        val course = call.course(courses)
        val exercise = exercises.written(call.parameters.getOrFail("id"))
        call.respondJson(
            answer(exercise, front.of(course.id, exercise)) {
                NamedPlaceAnswer(it.student, it.name, it.submission, it.median, it.low, it.high, it.error)
            },
        )
    }
}

/** Numbers of a point with the digits that count: more would tell the submission that they are of. */
private class RoundedPoint(
    point: FrontPoint,
) {
    val student = point.student
    val name = point.name
    val named = point.named
    val submission = point.submission
    val median = rounded(point.ratio.median())
    val low = rounded(point.ratio.low())
    val high = rounded(point.ratio.high())
    val error = point.error.takeIf { it.isFinite() }?.let(::rounded)
}

private val DIGITS = MathContext(3, RoundingMode.HALF_EVEN)

private fun rounded(number: Double) = BigDecimal.valueOf(number).round(DIGITS).toDouble()

private fun <T> answer(
    exercise: Exercise,
    points: List<FrontPoint>,
    told: (RoundedPoint) -> T,
): FrontAnswer<T> {
    val topic = Topics.named(exercise.topic())
    return FrontAnswer(
        topic.item(),
        topic.errorUnit(),
        SpeedPoints.fullUpTo(),
        ClassFront.LEAST,
        points.map { told(RoundedPoint(it)) },
    )
}
