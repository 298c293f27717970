package rasterlab.grader.course

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text

@Serializable
private data class CourseAnswer(
    val course: String,
    val code: String,
)

@Serializable
private data class CourseOverviewAnswer(
    val course: String,
    val code: String,
    val name: String,
    val madeAt: String,
    val students: Int,
)

@Serializable
private data class CoursesAnswer(
    val courses: List<CourseOverviewAnswer>,
    val next: String?,
)

@Serializable
private data class JoinResponse(
    val student: String,
    val token: String,
)

@Serializable
private data class RevokedAnswer(
    val student: String,
    val revokedAt: String,
)

/** Serves courses to instructors, inside `authenticate`. */
fun Route.courses(
    courses: Courses,
    accounts: Accounts,
) {
    post("/courses") {
        val instructor = call.instructor()
        val name = call.receiveJson("name") { it.anyText("name") }
        val course = courses.create(instructor.id, Name.of(name), call.idempotencyKey())
        call.respondJson(CourseAnswer(course.id, course.code), Created)
    }
    get("/courses") {
        val part = call.paging().of(courses.overviews(call.staff())) { it.course.id }
        call.linkNext(part)
        call.respondJson(CoursesAnswer(part.items.map(::answer), part.next))
    }
    get("/courses/{course}") {
        call.staff()
        val course = call.course(courses)
        call.respondJson(answer(courses.overview(course.id) ?: throw Rejection.UnknownCourse(course.id)))
    }
    get("/courses/{course}/students") {
        val who = call.staff()
        val course = call.course(courses)
        val part = call.paging(usual = Paging.WHOLE).of(courses.students(course.id).orEmpty()) { it.id }
        call.respondPart(part.map { it.told(withRoster = who is Identity.Instructor) })
    }
    get("/courses/{course}/students/{student}") {
        val who = call.staff()
        val course = call.course(courses)
        val student = courses.student(course.id, call.parameters.getOrFail("student"))
        call.respondJson(student.told(withRoster = who is Identity.Instructor))
    }
    post("/students/{student}/token") {
        val instructor = call.instructor()
        val student = call.parameters.getOrFail("student")
        val token =
            accounts.renewStudent(student, instructor.id, call.idempotencyKey())
                ?: throw Rejection.UnknownStudent(student)
        call.respondJson(JoinResponse(student, token), Created)
    }
    delete("/students/{student}/token") {
        val instructor = call.instructor()
        val student = call.parameters.getOrFail("student")
        call.respondJson(RevokedAnswer(student, accounts.revokeStudent(student, instructor.id).text()))
    }
}

/** The course that the address names by its id or its code. */
internal fun ApplicationCall.course(courses: Courses): Course {
    val told = parameters.getOrFail("course")
    return courses.find(told) ?: throw Rejection.UnknownCourse(told)
}

private fun answer(one: CourseOverview) =
    CourseOverviewAnswer(one.course.id, one.course.code, one.course.name, one.madeAt.text(), one.students)

/**
 * Lets anyone join, inside a rate limit. A repeatable request needs a key that nobody guesses,
 * because it gets the token again.
 */
fun Route.joining(courses: Courses) {
    post("/join") {
        val (code, name) = call.receiveJson("course", "name") { it.anyText("course") to it.anyText("name") }
        val student = courses.join(code, Name.of(name), call.idempotencyKey(secret = true))
        call.respondJson(JoinResponse(student.id, student.token), Created)
    }
}
