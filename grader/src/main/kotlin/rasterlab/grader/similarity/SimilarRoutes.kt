package rasterlab.grader.similarity

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondOutputStream
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.course.staff
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.text

@Serializable
private data class ProgramAnswer(
    val submission: String,
    val student: String,
    val course: String,
    val receivedAt: String,
)

@Serializable
private data class PairAnswer(
    val first: ProgramAnswer,
    val second: ProgramAnswer,
    val shared: Double,
    val rare: Int,
    val longest: Int,
    val sameWrong: List<String>,
)

@Serializable
private data class LikenessAnswer(
    val programs: Int,
    val pairs: List<PairAnswer>,
    val leftOut: List<ProgramAnswer>,
)

/**
 * Serves what is alike to staff, of one course or of all, inside `authenticate`; and all programs to instructors, for
 * other tools.
 */
fun Route.similarity(
    courses: Courses,
    exercises: Exercises,
    similar: Similar,
) {
    get("/exercises/{id}/similarity") {
        call.staff()
        call.respondJson(answer(similar.of(exercises.written(call.parameters.getOrFail("id")))))
    }
    get("/courses/{course}/exercises/{id}/similarity") {
        call.staff()
        val course = call.course(courses)
        call.respondJson(answer(similar.of(exercises.written(call.parameters.getOrFail("id")), course.id)))
    }
    get("/exercises/{id}/programs.zip") {
        call.instructor()
        call.respondPrograms(exercises.written(call.parameters.getOrFail("id")), similar)
    }
}

/** Answers with all programs for an exercise in one file. */
suspend fun ApplicationCall.respondPrograms(
    exercise: Exercise,
    similar: Similar,
) {
    val programs = similar.last(exercise.id())
    response.header(HttpHeaders.ContentDisposition, "attachment; filename=\"${exercise.id()}-programs.zip\"")
    respondOutputStream(ContentType.Application.Zip) { ProgramsFile.write(programs, exercise, this) }
}

/**
 * The exercise of that id that programs are written for.
 *
 * @throws Rejection.UnknownExercise where there is none, also where it asks for something else than a program
 */
fun Exercises.written(id: String): Exercise =
    find(id)?.takeIf { it.form() == Exercise.TaskKind.WRITE } ?: throw Rejection.UnknownExercise(id)

private fun answer(report: LikenessReport) =
    LikenessAnswer(report.programs, report.pairs.map(::answer), report.leftOut.map(::answer))

private fun answer(one: Likeness) =
    PairAnswer(
        answer(one.first),
        answer(one.second),
        one.pair.shared,
        one.pair.rare,
        one.pair.longest,
        one.sameWrong,
    )

private fun answer(one: HandedProgram) = ProgramAnswer(one.submission, one.name, one.course, one.receivedAt.text())
