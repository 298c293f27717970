package rasterlab.grader.rules

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import kotlinx.serialization.Serializable
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Name
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.typed

@Serializable
private data class ClonedAnswer(
    val course: String,
    val code: String,
)

/** Lets instructors make a course of an earlier one, inside `authenticate`. */
fun Route.clones(
    courses: Courses,
    clones: CourseClones,
) = post("/courses/{course}/clone") {
    val instructor = call.instructor()
    val (name, days) =
        call.receiveJson("name", "days") {
            it.anyText("name") to
                (it.tree().get("days")?.let { days -> typed("days", days) } ?: "${CourseClones.YEAR_OF_WEEKS}")
        }
    val made = clones.clone(call.course(courses), Name.of(name), days, instructor.id, call.idempotencyKey())
    call.respondJson(ClonedAnswer(made.id, made.code), Created)
}
