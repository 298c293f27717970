package rasterlab.grader.submission

import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import kotlinx.serialization.Serializable
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.staff
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.text

@Serializable
private data class ListedSubmissionAnswer(
    val id: String,
    val student: String,
    val name: String,
    val exercise: String,
    val revision: String,
    val attempt: Int,
    val state: String,
    val verdict: String?,
    val points: Int?,
    val of: Int?,
    val late: Boolean,
    val chosen: Boolean,
    val receivedAt: String,
)

@Serializable
private data class CourseSubmissionsAnswer(
    val submissions: List<ListedSubmissionAnswer>,
    val next: String?,
)

/** Lists the submissions of a course to staff, inside `authenticate`; of one exercise or one student where these are told. */
fun Route.courseSubmissions(
    courses: Courses,
    exercises: Exercises,
    submissions: Submissions,
) = get("/courses/{course}/submissions") {
    call.staff()
    val course = call.course(courses)
    val exercise = call.request.queryParameters["exercise"]
    val student = call.request.queryParameters["student"]?.let { courses.student(course.id, it).id }
    val part = submissions.ofCourse(course.id, exercise, student, call.paging())
    // One that the catalogue has no longer may have submissions.
    if (exercise != null && part.items.isEmpty()) exercises.named(exercise)
    call.linkNext(part)
    call.respondJson(CourseSubmissionsAnswer(part.items.map(::answer), part.next))
}

private fun answer(one: Listed) =
    ListedSubmissionAnswer(
        one.submission.id,
        one.submission.student,
        one.student,
        one.submission.exercise,
        one.revision,
        one.submission.attempt,
        one.submission.state.code,
        one.verdict,
        one.points,
        one.of,
        one.late,
        one.chosen,
        one.submission.receivedAt.text(),
    )
