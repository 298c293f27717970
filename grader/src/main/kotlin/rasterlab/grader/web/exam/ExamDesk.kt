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
import rasterlab.grader.web.FIELD_TIME
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.Refused
import rasterlab.grader.web.courseOf
import rasterlab.grader.web.instructorHere
import rasterlab.grader.web.problem
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.staffHere
import rasterlab.grader.web.texts
import rasterlab.grader.web.unbrokenTimes

/** Serves what staff do with exams: make one, watch it, change it, take its protocol away. */
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
        val ids = typed.getAll("exercise").orEmpty().onEach { exercises.named(it) }
        val made = exams.create(course, ExamForm(typed.told(), ids), who.id, key = null)
        call.respondRedirect("/instructor/exams/${made.id}")
    }
    get("/instructor/exams/{exam}") {
        val who = call.staffHere(accounts)
        sittings.settle()
        val exam = exams.find(call.parameters.getOrFail("exam"))
        call.respondExam(who, exam, exams.seats(exam), exams.events(exam), sittings.now(), exercises)
    }
    get("/instructor/exams/{exam}/protocol.csv") {
        call.instructorHere(accounts)
        call.respondProtocol(exams)
    }
    examChanges(accounts, exercises, exams)
    students(accounts, exams)
}

private fun Route.examChanges(
    accounts: Accounts,
    exercises: Exercises,
    exams: Exams,
) {
    get("/instructor/exams/{exam}/change") {
        val who = call.instructorHere(accounts)
        call.respondChange(who, exams.find(call.parameters.getOrFail("exam")), exercises, typed = null, refused = null)
    }
    post("/instructor/exams/{exam}/change") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val exam = exams.find(call.parameters.getOrFail("exam"))
        val typed = call.receiveForm()
        call.attributes.put(
            FORM_AGAIN,
            FormAgain { status, code, added ->
                call.respondChange(who, exam, exercises, typed, Refused(status, code, added(call.texts().language)))
            },
        )
        val ids = typed.getAll("exercise").orEmpty().onEach { exercises.named(it) }
        exams.change(exam.id, typed.told(), ids, who.id)
        call.respondRedirect("/instructor/exams/${exam.id}")
    }
    post("/instructor/exams/{exam}/end") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val ended = exams.end(call.parameters.getOrFail("exam"), who.id)
        call.respondRedirect("/instructor/exams/${ended.id}")
    }
    post("/instructor/exams/{exam}/drop") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val dropped = exams.drop(call.parameters.getOrFail("exam"), who.id)
        call.respondRedirect("/instructor/courses/${dropped.course}/exams")
    }
}

/** Gives a student minutes, or lets another session of theirs in. */
private fun Route.students(
    accounts: Accounts,
    exams: Exams,
) {
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

private fun Parameters.told(): Map<ExamField, String> = ExamField.entries.associateWith { get(it.code).orEmpty() }

private suspend fun ApplicationCall.respondChange(
    who: Identity.Instructor,
    exam: Exam,
    exercises: Exercises,
    typed: Parameters?,
    refused: Refused?,
) {
    val texts = texts()
    val heading = texts.say("exams.change.title", exam.name)
    respondPage(texts, who, heading, refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p("ways") { a("/instructor/exams/${exam.id}") { +texts.say("exams.change.back") } }
        p { +texts.say("exams.change.about") }
        section("card exam") {
            val held = ExamForm.told(exam) + listOf(ExamField.OPENS, ExamField.CLOSES).zip(exam.times()).toMap()
            examForm(
                texts,
                "/instructor/exams/${exam.id}/change",
                exercises,
                { typed?.get(it.code) ?: held.getValue(it) },
                typed?.let { it.getAll("exercise").orEmpty() } ?: exam.exercises,
                "exams.change.save",
            )
        }
    }
}

/** The first and the last moment as a browser's field for a date and a time has them. */
private fun Exam.times(): List<String> = listOf(opens, closes).map { FIELD_TIME.format(it.atZone(zone)) }

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
                    unbrokenTimes(" ${texts.said(exam)}")
                }
            }
        }
        if (who is Identity.Instructor) creation(texts, course, exercises, typed)
    }
}

/** The rules of an exam in a sentence. */
internal fun PageTexts.said(exam: Exam): String {
    val (opens, closes) = listOf(exam.opens, exam.closes).map(::time)
    return say(if (exam.fixed) "exam.fixed" else "exam.window", opens, closes, exam.minutes)
}

private fun FlowContent.creation(
    texts: PageTexts,
    course: Course,
    exercises: Exercises,
    typed: Parameters?,
) = section("card exam") {
    h2 { +texts.say("exams.new") }
    examForm(
        texts,
        "/instructor/courses/${course.id}/exams",
        exercises,
        { typed?.get(it.code) ?: FIRST_VALUES[it].orEmpty() },
        typed?.getAll("exercise").orEmpty(),
        "exams.create",
    )
}

private val FIRST_VALUES = mapOf(ExamField.ZONE to "UTC", ExamField.MINUTES to "90", ExamField.GRACE to "30")

/**
 * The rules of an exam to fill in.
 *
 * @param value what a field holds at first
 * @param chosen ids of the exercises that are checked at first
 * @param done key of the text on the button
 */
private fun FlowContent.examForm(
    texts: PageTexts,
    address: String,
    exercises: Exercises,
    value: (ExamField) -> String,
    chosen: List<String>,
    done: String,
) = form(address, method = FormMethod.post) {
    text(texts, ExamField.NAME, value)
    text(texts, ExamField.OPENS, value, InputType.dateTimeLocal)
    text(texts, ExamField.CLOSES, value, InputType.dateTimeLocal)
    text(texts, ExamField.ZONE, value)
    text(texts, ExamField.MINUTES, value, InputType.number)
    choice(texts, ExamField.STARTS, value, ExamForm.FIRST, ExamForm.FIXED)
    text(texts, ExamField.GRACE, value, InputType.number)
    text(texts, ExamField.ADDRESSES, value, asked = false)
    choice(texts, ExamField.SECOND, value, ExamForm.REFUSE, ExamForm.END)
    fieldSet {
        legend { +texts.say("exams.exercises") }
        exercises.all.forEach { exercise ->
            label("consent") {
                input(InputType.checkBox, name = "exercise") {
                    this.value = exercise.id()
                    checked = exercise.id() in chosen
                }
                span { +exercise.title(texts.language) }
            }
        }
    }
    button { +texts.say(done) }
}

private fun FORM.text(
    texts: PageTexts,
    field: ExamField,
    value: (ExamField) -> String,
    type: InputType = InputType.text,
    asked: Boolean = true,
) = label {
    span { +texts.say("exams.${field.code}") }
    input(type, name = field.code) {
        this.value = value(field)
        required = asked
        if (type == InputType.dateTimeLocal) step = "1"
        attributes["autocomplete"] = "off"
    }
}

private fun FORM.choice(
    texts: PageTexts,
    field: ExamField,
    value: (ExamField) -> String,
    vararg codes: String,
) = label {
    span { +texts.say("exams.${field.code}") }
    select {
        name = field.code
        codes.forEach { code ->
            option {
                this.value = code
                selected = value(field) == code
                +texts.say("exams.${field.code}.$code")
            }
        }
    }
}
