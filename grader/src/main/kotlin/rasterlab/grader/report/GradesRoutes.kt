package rasterlab.grader.report

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.withCharset
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import rasterlab.grader.course.Courses
import rasterlab.grader.course.instructor
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.language
import rasterlab.grader.rules.CourseExercises
import rasterlab.grader.submission.Marks

/** The marks of a course, from where they are stored to the file that leaves the server. */
class Grades(
    private val courses: Courses,
    private val marks: Marks,
    private val exercises: Exercises,
    private val chosen: CourseExercises,
) {
    /** @throws Rejection.UnknownCourse where there is no course of that id or code */
    fun of(
        course: String,
        reader: GradesReader,
        language: String,
    ): String {
        val id = courses.find(course)?.id ?: throw Rejection.UnknownCourse(course)
        val points = marks.of(id)
        val graded = chosen.graded(id).toSet()
        val lines =
            courses.students(id).orEmpty().map {
                GradesLine(it, it.fields, points[it.id].orEmpty().filterKeys(graded::contains))
            }
        return GradesFile(exercises.all.filter { it.id() in graded }, language).write(reader, lines)
    }
}

/** Serves marks to instructors, inside `authenticate`; `?for=moodle` or `?for=canvas` gives what these take back. */
fun Route.grades(grades: Grades) =
    get("/courses/{course}/grades.csv") {
        call.instructor()
        call.respondGrades(grades)
    }

/** Answers with the marks of the course that the address names, as a file. */
suspend fun ApplicationCall.respondGrades(grades: Grades) {
    val asked = request.queryParameters["for"] ?: GradesReader.PEOPLE.code
    val codes = GradesReader.entries.map { it.code }
    val reader =
        GradesReader.entries.firstOrNull { it.code == asked }
            ?: throw Rejection.Malformed("for is '$asked', allowed are ${codes.joinToString()}")
    val file = grades.of(parameters.getOrFail("course"), reader, language())
    response.header(HttpHeaders.ContentDisposition, "attachment; filename=\"grades.csv\"")
    respondText(file, ContentType.Text.CSV.withCharset(Charsets.UTF_8))
}
