package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FormEncType
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.textArea
import kotlinx.html.unsafe
import rasterlab.exercises.Exercise
import rasterlab.exercises.course.Chapter
import rasterlab.exercises.formula.Formulas
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Deadlines
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.respondPicture
import rasterlab.grader.exercise.respondStarter
import rasterlab.grader.exercise.starterFile
import rasterlab.grader.hint.Hints
import rasterlab.grader.hint.TakenHint
import rasterlab.grader.storage.Secrets
import rasterlab.grader.submission.FormField
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Intake
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.Submissions
import rasterlab.grader.submission.receiveFields
import rasterlab.grader.submission.sourceOf
import java.time.Instant
import java.time.InstantSource
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter

/** What there is to do, and where to hand it in. */
fun Route.exercisePages(
    accounts: Accounts,
    deadlines: Deadlines,
    exercises: Exercises,
    sheets: Sheets,
    hints: Hints,
    submissions: Submissions,
    intake: Intake,
    queue: GradingQueue,
    clock: InstantSource,
) {
    val formulas = Formulas()
    get("/exercises") { call.respondExercises(call.someone(accounts), exercises, deadlines, submissions) }
    get("/exercises/{id}") {
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val who = call.someone(accounts)
        val sheet = if (exercise.form() == Exercise.Form.PREDICT) sheets.starter(who, exercise) else ""
        val taken = if (who is Identity.Student) hints.taken(who, exercise) else emptyList()
        val due = deadlines.of(who)[exercise.id()]
        val stand = ExerciseStand(sheet, taken, due, over = due != null && clock.instant() > due)
        call.respondExercise(who, exercises, exercise, stand, submissions, formulas)
    }
    get("/exercises/{id}/starter") {
        val who = call.someone(accounts)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        call.respondStarter(exercise, sheets.starter(who, exercise))
    }
    get("/exercises/{id}/pictures/{name}") {
        call.someone(accounts)
        call.respondPicture(exercises.named(call.parameters.getOrFail("id")), call.parameters.getOrFail("name"))
    }
    post("/exercises/{id}") {
        call.requireOwnForm()
        val student = call.studentHere(accounts)
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val fields = call.receiveFields()
        val source = sourceOf(fields)
        val accepted = intake.accept(student, exercise, source, onceOf(fields, source))
        queue.ring(accepted.id)
        call.respondRedirect("/submissions/${accepted.id}")
    }
}

/**
 * A key that is the same when one page sends one source again, as by a double click. Its space keeps
 * it apart from those that programs choose. Another source from the same page is another attempt.
 */
private fun onceOf(
    fields: List<FormField>,
    source: String,
) = fields.firstOrNull { it.name == ONCE }?.let { "page ${Secrets.hash(it.content.decodeToString() + "\n" + source)}" }

/** The way through the course, and how far a student has come on it. */
private suspend fun ApplicationCall.respondExercises(
    who: Identity,
    exercises: Exercises,
    deadlines: Deadlines,
    submissions: Submissions,
) {
    val texts = texts()
    val due = deadlines.of(who)
    val bests = submissions.bestsOf(who)
    respondPage(texts, who, texts.say("exercises.title")) {
        if (exercises.all.isEmpty()) p { +texts.say("exercises.none") }
        Chapter.of(exercises.all).forEach { chapter(texts, it, due, bests) }
    }
}

/** A topic: what prepares for its exercises, and these. */
private fun FlowContent.chapter(
    texts: PageTexts,
    chapter: Chapter,
    deadlines: Map<String, Instant>,
    bests: Map<String, Int?>?,
) = section("chapter") {
    h2 {
        id = chapter.topic()
        +chapter.title(texts.language)
    }
    p("lab") { +texts.say("exercises.lab", chapter.labTitle(texts.language)) }
    div("columns") {
        chapter.exercises().forEach { exercise ->
            a("/exercises/${exercise.id()}", classes = "card exercise") {
                span("title") { +exercise.title(texts.language) }
                span { +about(texts, exercise) }
                deadlines[exercise.id()]?.let {
                    span(
                        "state",
                    ) { +texts.say("exercises.deadline", UTC_MINUTE.format(it)) }
                }
                if (bests != null) span("state") { +state(texts, exercise, bests) }
            }
        }
    }
}

/** Writes times in UTC, since a server does not know where its students are. */
private val UTC_MINUTE = DateTimeFormatter.ofPattern("uuuu-MM-dd HH:mm 'UTC'").withZone(ZoneOffset.UTC)

/** Tells its kind, its points, and how long it takes where that is known. */
private fun about(
    texts: PageTexts,
    exercise: Exercise,
): String {
    val minutes = exercise.minutes()
    return listOfNotNull(
        texts.say("exercises.kind.${exercise.form().code()}"),
        texts.say("exercises.points.among", exercise.points().total()),
        if (minutes.isPresent) texts.say("exercises.minutes", minutes.asInt) else null,
    ).joinToString(" · ")
}

private fun state(
    texts: PageTexts,
    exercise: Exercise,
    bests: Map<String, Int?>,
): String {
    if (exercise.id() !in bests) return texts.say("exercises.state.none")
    val best = bests[exercise.id()] ?: return texts.say("exercises.state.waiting")
    return texts.say("exercises.state.best", best, exercise.points().total())
}

/**
 * Where somebody stands with an exercise.
 *
 * @param sheet that the next attempt answers; empty where there is none
 * @param due the deadline, or null
 * @param over whether that has passed
 */
private class ExerciseStand(
    val sheet: String,
    val taken: List<TakenHint>,
    val due: Instant?,
    val over: Boolean,
)

private suspend fun ApplicationCall.respondExercise(
    who: Identity,
    exercises: Exercises,
    exercise: Exercise,
    stand: ExerciseStand,
    submissions: Submissions,
    formulas: Formulas,
) {
    val texts = texts()
    val mine = if (who is Identity.Student) submissions.ofStudent(who.id, exercise.id()) else null
    respondPage(texts, who, exercise.title(texts.language)) {
        val plan = exercise.points()
        p("plan") {
            +texts.say("exercises.points", plan.total())
            if (exercise.form() == Exercise.Form.WRITE) {
                +" — "
                +texts.say("exercise.plan", plan.accuracy(), plan.stability(), plan.speed())
            }
        }
        stand.due?.let { due ->
            p("plan") { +texts.say(if (stand.over) "exercise.over" else "exercise.due", UTC_MINUTE.format(due)) }
        }
        div("columns wide") {
            article("card statement") {
                val statement = exercise.statement(texts.language).withoutTitle()
                val html =
                    markdownAsHtml(statement, formulas, texts.language) { "/exercises/${exercise.id()}/pictures/$it" }
                unsafe { +html }
            }
            section {
                div("card") {
                    p {
                        val starter = "/exercises/${exercise.id()}/starter"
                        val words = if (stand.sheet.isEmpty()) "exercise.starter" else "exercise.sheet"
                        a(starter) { +"${texts.say(words)} (${exercise.starterFile()})" }
                    }
                    if (mine != null) handIn(texts, exercise, stand.sheet)
                }
                if (mine != null && exercise.hints().isNotEmpty()) hintSteps(texts, exercise, stand.taken, formulas)
                if (mine != null) {
                    h2 { +texts.say("exercise.mine") }
                    if (mine.isEmpty()) p { +texts.say("exercise.mine.none") } else attemptTable(texts, exercises, mine)
                }
            }
        }
    }
}

/** The field that tells one opened page from the next. */
private const val ONCE = "once"

/** The page shows the title itself. */
private fun String.withoutTitle() = if (startsWith("# ")) substringAfter('\n', "") else this

private fun FlowContent.handIn(
    texts: PageTexts,
    exercise: Exercise,
    sheet: String,
) {
    h2 { +texts.say("exercise.submit") }
    form("/exercises/${exercise.id()}", encType = FormEncType.multipartFormData, method = FormMethod.post) {
        input(InputType.hidden, name = ONCE) { value = Secrets.newId() }
        label {
            span { +texts.say("exercise.file.${exercise.form().code()}") }
            input(InputType.file, name = "source") {
                accept =
                    ".${exercise.form().ending()},${exercise.form().mediaType()}"
            }
        }
        label {
            span { +texts.say("exercise.paste.${exercise.form().code()}") }
            textArea(rows = if (sheet.isEmpty()) "10" else "24") {
                name = "source"
                attributes["spellcheck"] = "false"
                +sheet
            }
        }
        button { +texts.say("exercise.submit.do") }
    }
}
