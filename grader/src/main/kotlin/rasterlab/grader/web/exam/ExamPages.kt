// The pages of exams: ExamPages for students, ExamDesk for staff.
package rasterlab.grader.web.exam

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.response.respondText
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormMethod
import kotlinx.html.article
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.p
import kotlinx.html.role
import kotlinx.html.script
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.summary
import kotlinx.html.unsafe
import rasterlab.exercises.Exercise
import rasterlab.exercises.formula.Formulas
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Courses
import rasterlab.grader.exam.Exam
import rasterlab.grader.exam.Exams
import rasterlab.grader.exam.Sitting
import rasterlab.grader.exam.SittingState
import rasterlab.grader.exam.Sittings
import rasterlab.grader.exam.examinee
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.submission.FormField
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.SheetDraft
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.receiveFields
import rasterlab.grader.submission.sourceOf
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.Refused
import rasterlab.grader.web.VIEWED
import rasterlab.grader.web.editor
import rasterlab.grader.web.markdownAsHtml
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.sourceField
import rasterlab.grader.web.studentHere
import rasterlab.grader.web.texts
import rasterlab.grader.web.unbrokenTimes

/** Says in a form that a script sends it, which wants the seconds that are left and no page. */
private const val QUIET = "quiet"
private const val EXAM_ROWS = 16

/** Serves what students do at exams: open one, write, hand in, end it; and what staff do with exams. */
fun Route.examPages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    exams: Exams,
    sittings: Sittings,
    sheets: Sheets,
) {
    examDesk(accounts, courses, exercises, exams, sittings)
    get("/exams") { call.respondExams(accounts, sittings) }
    get("/exams/{exam}") { call.respondSitting(accounts, exercises, sittings, sheets) }
    post("/exams/{exam}/open") {
        call.requireOwnForm()
        val exam = call.parameters.getOrFail("exam")
        sittings.open(exam, call.examinee(call.studentHere(accounts)))
        call.respondRedirect("/exams/$exam")
    }
    post("/exams/{exam}/exercises/{id}/draft") {
        call.requireOwnForm()
        val examinee = call.examinee(call.studentHere(accounts))
        val (exam, exercise) = listOf("exam", "id").map { call.parameters.getOrFail(it) }
        val fields = call.receiveFields()
        val sitting = sittings.keep(exam, exercise, fields.draft(exercises.named(exercise)), examinee)
        if (fields.text(QUIET).isEmpty()) {
            call.respondRedirect("/exams/$exam#$exercise")
        } else {
            call.respondText("${sitting.left(sittings.now())}")
        }
    }
    post("/exams/{exam}/exercises/{id}") {
        call.requireOwnForm()
        val examinee = call.examinee(call.studentHere(accounts))
        val exam = call.parameters.getOrFail("exam")
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val fields = call.receiveFields()
        val form = HandedForm.of(exercise, fields)
        form.answers?.let { answers ->
            sittings.keep(exam, exercise.id(), SheetDraft.text(answers), examinee)
            call.attributes.put(
                FORM_AGAIN,
                FormAgain { status, code, added ->
                    val refused = Refused(status, code, added(call.texts().language))
                    call.respondSitting(accounts, exercises, sittings, sheets, exercise to refused)
                },
            )
        }
        val source = form.source()
        val draft = form.answers?.let(SheetDraft::text) ?: source
        sittings.handIn(exam, exercise, source, form.once(source), examinee, draft)
        call.respondRedirect("/exams/$exam#${exercise.id()}")
    }
    post("/exams/{exam}/end") {
        call.requireOwnForm()
        sittings.end(call.parameters.getOrFail("exam"), call.examinee(call.studentHere(accounts)))
        call.respondRedirect("/exams")
    }
}

private fun List<FormField>.text(name: String) = firstOrNull { it.name == name }?.content?.decodeToString().orEmpty()

/** The text of the form, or what is typed into the fields of a sheet; it may be empty. */
private fun List<FormField>.draft(exercise: Exercise): String {
    HandedForm.of(exercise, this).answers?.let { return SheetDraft.text(it) }
    return if (text("source").isBlank()) "" else sourceOf(this)
}

private suspend fun ApplicationCall.respondExams(
    accounts: Accounts,
    sittings: Sittings,
) {
    val student = studentHere(accounts)
    sittings.settle()
    val all = sittings.of(student)
    val texts = texts()
    respondPage(texts, student, texts.say("exam.title")) {
        if (all.isEmpty()) p { +texts.say("exam.none") }
        all.forEach { one ->
            section("card exam") {
                h2 { +one.exam.name }
                p { unbrokenTimes(texts.describe(one)) }
                state(texts, one, one.state(sittings.now()))
            }
        }
    }
}

private fun PageTexts.describe(sitting: Sitting): String {
    val exam = sitting.exam
    val (opens, closes) = listOf(exam.opens, exam.closes).map(::time)
    return say(if (exam.fixed) "exam.fixed" else "exam.window", opens, closes, exam.minutes + sitting.extra)
}

private fun FlowContent.state(
    texts: PageTexts,
    sitting: Sitting,
    state: SittingState,
) {
    when (state) {
        SittingState.WAITING -> {
            p { +texts.say("exam.state.waiting") }
        }

        SittingState.READY, SittingState.RUNNING -> {
            p { +texts.say(if (sitting.exam.takesOver) "exam.rules.end" else "exam.rules.refuse") }
            form("/exams/${sitting.exam.id}/open", method = FormMethod.post) {
                button { +texts.say(if (state == SittingState.READY) "exam.open" else "exam.go.on") }
            }
        }

        SittingState.OVER -> {
            p { +texts.say(if (sitting.started == null) "exam.state.missed" else "exam.state.over") }
        }
    }
}

private suspend fun ApplicationCall.respondSitting(
    accounts: Accounts,
    exercises: Exercises,
    sittings: Sittings,
    sheets: Sheets,
    refused: Pair<Exercise, Refused>? = null,
) {
    val student = studentHere(accounts)
    // To enter an exam is noted, and begins a session.
    if (attributes.contains(VIEWED)) throw Rejection.OnlyLooks()
    val sitting =
        try {
            sittings.enter(parameters.getOrFail("exam"), examinee(student))
        } catch (over: Rejection.ExamOver) {
            return respondRedirect("/exams")
        }
    val texts = texts()
    val drafts = sittings.drafts(sitting)
    val formulas = Formulas()
    respondPage(texts, student, sitting.exam.name, refused?.second?.status ?: HttpStatusCode.OK) {
        clock(texts, sitting, sitting.left(sittings.now()))
        sitting.exam.exercises.mapNotNull(exercises::find).forEach { exercise ->
            section("exam") {
                id = exercise.id()
                attributes["aria-label"] = exercise.title(texts.language)
                div("columns wide") {
                    article("card statement") {
                        val statement = exercise.statement(texts.language)
                        unsafe {
                            +markdownAsHtml(statement, formulas, texts.language) { name ->
                                "/exercises/${exercise.id()}/pictures/$name"
                            }
                        }
                    }
                    val draft = drafts[exercise.id()]
                    val sheet = sheet(sheets, student, exercise, draft)
                    val why = refused?.second.takeIf { refused?.first?.id() == exercise.id() }
                    work(texts, sitting, exercise, draft, sheet, why) {
                        val text = draft?.source ?: sheets.starter(student, exercise)
                        sourceField(texts.say("exam.text"), exercise.form().ending(), text, EXAM_ROWS)
                    }
                }
            }
        }
        details("card exam") {
            summary { +texts.say("exam.end") }
            p { +texts.say("exam.end.about") }
            form("/exams/${sitting.exam.id}/end", method = FormMethod.post) { button { +texts.say("exam.end.do") } }
        }
        script(src = "/assets/exam.js") { defer = true }
        editor()
    }
}

/** The time that is left, as it was when the page was asked for; a script lets it run. */
private fun FlowContent.clock(
    texts: PageTexts,
    sitting: Sitting,
    left: Long,
) = p("clock card") {
    id = "clock"
    role = "timer"
    attributes["data-exam"] = "/exams/${sitting.exam.id}"
    attributes["data-left"] = "$left"
    attributes["data-grace"] = "${sitting.exam.grace}"
    +"${texts.say("exam.left")} "
    span("left") { +(if (left >= 60) texts.say("exam.minutes", left / 60) else texts.say("exam.seconds", left)) }
    sitting.ends?.let {
        +" "
        span("legend") { unbrokenTimes(texts.say("exam.ends", texts.time(it))) }
    }
}
