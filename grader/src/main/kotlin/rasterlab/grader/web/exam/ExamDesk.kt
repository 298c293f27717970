package rasterlab.grader.web.exam

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FORM
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.fieldSet
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.legend
import kotlinx.html.li
import kotlinx.html.option
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.select
import kotlinx.html.span
import kotlinx.html.ul
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exam.Exam
import rasterlab.grader.exam.ExamField
import rasterlab.grader.exam.ExamForm
import rasterlab.grader.exam.Exams
import rasterlab.grader.exam.Sittings
import rasterlab.grader.exam.respondProtocol
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.Refused
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.forPeople
import rasterlab.grader.web.instructorHere
import rasterlab.grader.web.problem
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts

/** Serves what staff do with exams: make one, watch it, give minutes, let another session in, take the protocol away. */
internal fun Route.examDesk(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    exams: Exams,
    sittings: Sittings,
) {
    get("/instructor/courses/{course}/exams") {
        val who = call.staffHere(accounts)
        call.respondAll(who, call.courseOf(courses), exercises, exams, typed = null, refused = null)
    }
    post("/instructor/courses/{course}/exams") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val course = call.courseOf(courses)
        val typed = call.receiveForm()
        call.attributes.put(
            FORM_AGAIN,
            FormAgain { status, code, added ->
                val refused = Refused(status, code, added(call.texts().language))
                call.respondAll(who, course, exercises, exams, typed, refused)
            },
        )
        val told = ExamField.entries.associateWith { typed[it.code].orEmpty() }
        val ids = typed.getAll("exercise").orEmpty().onEach { exercises.named(it) }
        val made = exams.create(course, ExamForm(told, ids), who.id)
        call.respondRedirect("/instructor/exams/${made.id}")
    }
    get("/instructor/exams/{exam}") {
        val who = call.staffHere(accounts)
        sittings.settle()
        val exam = exams.find(call.parameters.getOrFail("exam"))
        call.respondExam(who, exam, exams.seats(exam), exams.events(exam), sittings.now(), exercises)
    }
    get("/instructor/exams/{exam}/protocol.csv") {
        call.staffHere(accounts)
        call.respondProtocol(exams)
    }
    post("/instructor/exams/{exam}/drop") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val dropped = exams.drop(call.parameters.getOrFail("exam"), who.id)
        call.respondRedirect("/instructor/courses/${dropped.course}/exams")
    }
    post("/instructor/exams/{exam}/students/{student}/extra") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val exam = exams.find(call.parameters.getOrFail("exam"))
        exams.give(exam, call.parameters.getOrFail("student"), call.receiveForm()["extra"].orEmpty(), who.id)
        call.respondRedirect("/instructor/exams/${exam.id}")
    }
    post("/instructor/exams/{exam}/students/{student}/release") {
        call.requireOwnForm()
        val who = call.staffHere(accounts)
        val exam = exams.find(call.parameters.getOrFail("exam"))
        exams.release(exam, call.parameters.getOrFail("student"), who.id)
        call.respondRedirect("/instructor/exams/${exam.id}")
    }
}

private suspend fun ApplicationCall.respondAll(
    who: Identity.StaffIdentity,
    course: Course,
    exercises: Exercises,
    exams: Exams,
    typed: Parameters?,
    refused: Refused?,
) {
    val texts = texts()
    val all = exams.ofCourse(course.id)
    val heading = texts.say("exams.title", course.name)
    respondPage(texts, who, heading, refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p("ways") { a("/instructor") { +texts.say("token.back") } }
        if (all.isEmpty()) p { +texts.say("exams.none") }
        ul("courses") {
            all.forEach { exam ->
                li {
                    a("/instructor/exams/${exam.id}") { +exam.name }
                    +" ${texts.said(exam)}"
                }
            }
        }
        if (who is Identity.Instructor) creation(texts, course, exercises, typed)
    }
}

/** The rules of an exam in a sentence. */
internal fun PageTexts.said(exam: Exam): String {
    val (opens, closes) = listOf(exam.opens, exam.closes).map { it.forPeople(exam.zone) }
    return say(if (exam.fixed) "exam.fixed" else "exam.window", opens, closes, exam.minutes)
}

private fun FlowContent.creation(
    texts: PageTexts,
    course: Course,
    exercises: Exercises,
    typed: Parameters?,
) = section("card exam") {
    h2 { +texts.say("exams.new") }
    form("/instructor/courses/${course.id}/exams", method = FormMethod.post) {
        text(texts, ExamField.NAME, typed, "")
        text(texts, ExamField.OPENS, typed, "", InputType.dateTimeLocal)
        text(texts, ExamField.CLOSES, typed, "", InputType.dateTimeLocal)
        text(texts, ExamField.ZONE, typed, "UTC")
        text(texts, ExamField.MINUTES, typed, "90", InputType.number)
        choice(texts, ExamField.STARTS, typed, ExamForm.FIRST, ExamForm.FIXED)
        text(texts, ExamField.GRACE, typed, "30", InputType.number)
        text(texts, ExamField.ADDRESSES, typed, "", asked = false)
        choice(texts, ExamField.SECOND, typed, ExamForm.REFUSE, ExamForm.END)
        fieldSet {
            legend { +texts.say("exams.exercises") }
            exercises.all.forEach { exercise ->
                label("consent") {
                    input(InputType.checkBox, name = "exercise") {
                        value = exercise.id()
                        checked = exercise.id() in typed?.getAll("exercise").orEmpty()
                    }
                    span { +exercise.title(texts.language) }
                }
            }
        }
        button { +texts.say("exams.create") }
    }
}

private fun FORM.text(
    texts: PageTexts,
    field: ExamField,
    typed: Parameters?,
    first: String,
    type: InputType = InputType.text,
    asked: Boolean = true,
) = label {
    span { +texts.say("exams.${field.code}") }
    input(type, name = field.code) {
        value = typed?.get(field.code) ?: first
        required = asked
        attributes["autocomplete"] = "off"
    }
}

private fun FORM.choice(
    texts: PageTexts,
    field: ExamField,
    typed: Parameters?,
    vararg codes: String,
) = label {
    span { +texts.say("exams.${field.code}") }
    select {
        name = field.code
        codes.forEach { code ->
            option {
                value = code
                selected = typed?.get(field.code) == code
                +texts.say("exams.${field.code}.$code")
            }
        }
    }
}
