package rasterlab.grader.exam

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.http.withCharset
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.json.JsonFields
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.course.staff
import rasterlab.grader.course.student
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.language
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.problem.typed
import rasterlab.grader.rules.named
import rasterlab.grader.rules.said
import rasterlab.grader.storage.text
import java.time.Instant

@Serializable
private data class ExamAnswer(
    val exam: String,
    val course: String,
    val name: String,
    val exercises: List<String>,
    val opens: String,
    val closes: String,
    val zone: String,
    val minutes: Int,
    val starts: String,
    val grace: Int,
    val addresses: String,
    val second: String,
    val notes: List<String>,
)

@Serializable
private data class SeatAnswer(
    val student: String,
    val name: String,
    val state: String,
    val extra: Int,
    val startedAt: String?,
    val endsAt: String?,
    val endedAt: String?,
    val address: String?,
)

@Serializable
private data class WatchedExamAnswer(
    val exam: ExamAnswer,
    val students: List<SeatAnswer>,
    val next: String?,
)

@Serializable
private data class OwnExamAnswer(
    val exam: String,
    val name: String,
    val state: String,
    val opens: String,
    val closes: String,
    val minutes: Int,
    val endsAt: String?,
    val secondsLeft: Long,
)

/**
 * Serves exams to staff, inside `authenticate`, and tells students when theirs are: these work on them in a browser,
 * whose session is the one that may.
 */
fun Route.exams(
    courses: Courses,
    exercises: Exercises,
    exams: Exams,
    sittings: Sittings,
) {
    get("/exams") {
        val student = call.student()
        sittings.settle()
        val part = call.paging(Paging.WHOLE).of(sittings.of(student)) { it.exam.id }
        call.respondPart(part.map { own(it, sittings.now()) })
    }
    get("/courses/{course}/exams") {
        call.staff()
        val all = exams.ofCourse(call.course(courses).id)
        call.respondPart(call.paging(Paging.WHOLE).of(all) { it.id }.map { one -> call.answer(one) })
    }
    post("/courses/{course}/exams") {
        val instructor = call.instructor()
        val course = call.course(courses)
        val form = call.receiveJson(*CODES) { ExamForm(told(it), it.texts(EXERCISES).onEach(exercises::named)) }
        call.respondJson(call.answer(exams.create(course, form, instructor.id, call.idempotencyKey())), Created)
    }
    get("/exams/{exam}") {
        call.staff()
        sittings.settle()
        call.respondSeats(exams, sittings.now())
    }
    patch("/exams/{exam}") {
        val instructor = call.instructor()
        val (told, ids) =
            call.receiveJson(*CODES) { body ->
                told(body) to if (body.has(EXERCISES)) body.texts(EXERCISES).onEach(exercises::named) else null
            }
        call.respondJson(call.answer(exams.change(call.examId(), told, ids, instructor.id)))
    }
    delete("/exams/{exam}") {
        val instructor = call.instructor()
        call.respondJson(call.answer(exams.drop(call.examId(), instructor.id)))
    }
    get("/exams/{exam}/protocol.csv") {
        call.instructor()
        call.respondProtocol(exams)
    }
    patch("/exams/{exam}/students/{student}") {
        val instructor = call.instructor()
        val exam = exams.find(call.examId())
        val minutes = call.receiveJson("extra") { typed("extra", it.tree("extra")) }
        exams.give(exam, call.studentId(), minutes, instructor.id)
        call.respondSeat(exams, exam, sittings.now())
    }
    post("/exams/{exam}/students/{student}/release") {
        val staff = call.staff()
        val exam = exams.find(call.examId())
        exams.release(exam, call.studentId(), staff.id)
        call.respondSeat(exams, exam, sittings.now())
    }
}

/** Answers with the protocol of the exam that the address names, as a file. */
suspend fun ApplicationCall.respondProtocol(exams: Exams) {
    val exam = exams.find(examId())
    response.header(HttpHeaders.ContentDisposition, "attachment; filename=\"protocol.csv\"")
    respondText(ExamEvents.csv(exams.events(exam)), ContentType.Text.CSV.withCharset(Charsets.UTF_8))
}

private const val EXERCISES = "exercises"
private val CODES = ExamField.entries.map { it.code }.toTypedArray() + EXERCISES

/** The fields as texts; a number may stand for what is one. */
private fun told(body: JsonFields): Map<ExamField, String> =
    ExamField.entries.filter { body.tree().has(it.code) }.associateWith { typed(it.code, body.tree().get(it.code)) }

private fun ApplicationCall.examId() = parameters.getOrFail("exam")

private fun ApplicationCall.studentId() = parameters.getOrFail("student")

/** Answers with an exam and the part of its students that is asked for. */
private suspend fun ApplicationCall.respondSeats(
    exams: Exams,
    now: Instant,
) {
    val exam = exams.find(examId())
    val part = paging(Paging.WHOLE).of(exams.seats(exam)) { it.sitting.student }
    linkNext(part)
    respondJson(WatchedExamAnswer(answer(exam), part.items.map { answer(it, now) }, part.next))
}

private suspend fun ApplicationCall.respondSeat(
    exams: Exams,
    exam: Exam,
    now: Instant,
) {
    val seat = exams.seats(exam).firstOrNull { it.sitting.student == studentId() }
    respondJson(answer(seat ?: throw Rejection.UnknownStudent(studentId()), now))
}

private fun ApplicationCall.answer(exam: Exam) =
    ExamAnswer(
        exam.id,
        exam.course,
        exam.name,
        exam.exercises,
        exam.opens.text(),
        exam.closes.text(),
        exam.zone.named(),
        exam.minutes,
        ExamForm.told(exam).getValue(ExamField.STARTS),
        exam.grace,
        exam.addresses.text,
        ExamForm.told(exam).getValue(ExamField.SECOND),
        exam.repeatedHours().said(language()),
    )

private fun answer(
    seat: SeatedStudent,
    now: Instant,
): SeatAnswer {
    val sitting = seat.sitting
    return SeatAnswer(
        sitting.student,
        seat.name,
        sitting.state(now).code,
        sitting.extra,
        sitting.started?.text(),
        sitting.ends?.text(),
        sitting.ended?.text(),
        sitting.address,
    )
}

private fun own(
    sitting: Sitting,
    now: Instant,
): OwnExamAnswer {
    val exam = sitting.exam
    val state = sitting.state(now)
    return OwnExamAnswer(
        exam.id,
        exam.name,
        state.code,
        exam.opens.text(),
        exam.closes.text(),
        exam.minutes + sitting.extra,
        sitting.ends?.text(),
        if (state == SittingState.OVER) 0 else sitting.left(now),
    )
}
