package rasterlab.grader.course

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.text

@Serializable
private data class CourseAnswer(
    val course: String,
    val code: String,
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

@Serializable
private data class StudentAnswer(
    val student: String,
    val number: Int,
    val name: String,
    val shownName: String,
    val joinedAt: String,
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
    get("/courses/{course}/students") {
        call.staff()
        val course = call.parameters.getOrFail("course")
        val students = courses.students(course) ?: throw Rejection.UnknownCourse(course)
        call.respondJson(students.map { StudentAnswer(it.id, it.number, it.name, it.shownName, it.joinedAt.text()) })
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
