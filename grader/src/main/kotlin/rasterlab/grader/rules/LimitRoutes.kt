package rasterlab.grader.rules

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import kotlinx.serialization.Serializable
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.course.staff
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.typed

/** Tells what holds for each student of the course, and the most that the server allows. */
@Serializable
private data class LimitsAnswer(
    val submissionsPerMinute: Int,
    val waiting: Int,
    val mostPerMinute: Int,
    val mostWaiting: Int,
)

/** Tells staff how much a student may hand in, and lets instructors set it, inside `authenticate`. */
fun Route.courseLimits(
    courses: Courses,
    limits: CourseLimits,
) {
    get("/courses/{course}/limits") {
        call.staff()
        call.respondJson(told(limits, limits.of(call.course(courses))))
    }
    patch("/courses/{course}/limits") {
        val instructor = call.instructor()
        val told =
            call.receiveJson(*LimitField.entries.map { it.code }.toTypedArray()) { body ->
                LimitField.entries
                    .filter { body.tree().has(it.code) }
                    .associateWith { typed(it.code, body.tree().get(it.code)) }
            }
        call.respondJson(told(limits, limits.change(call.course(courses), told, instructor.id)))
    }
}

private fun told(
    limits: CourseLimits,
    now: CourseLimit,
) = LimitsAnswer(now.limits.perMinute, now.limits.waiting, limits.most.perMinute, limits.most.waiting)
