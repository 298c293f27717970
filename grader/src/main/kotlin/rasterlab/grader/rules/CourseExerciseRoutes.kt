package rasterlab.grader.rules

import io.ktor.server.routing.Route
import io.ktor.server.routing.put
import kotlinx.serialization.Serializable
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson

@Serializable
private data class CourseExercisesAnswer(
    val exercises: List<String>,
)

/** Lets instructors choose the exercises of a course, inside `authenticate`. */
fun Route.courseExercises(
    courses: Courses,
    chosen: CourseExercises,
) = put("/courses/{course}/exercises") {
    val instructor = call.instructor()
    val ids =
        call.receiveJson("exercises") { body ->
            if (body.tree("exercises").isNull) null else body.texts("exercises")
        }
    call.respondJson(CourseExercisesAnswer(chosen.choose(call.course(courses), ids, instructor.id)))
}
