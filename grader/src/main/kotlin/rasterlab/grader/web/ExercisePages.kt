package rasterlab.grader.web

import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.div
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import rasterlab.exercises.Exercise
import rasterlab.exercises.course.Chapter
import rasterlab.exercises.formula.Formulas
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.respondPicture
import rasterlab.grader.exercise.respondStarter
import rasterlab.grader.hint.Hints
import rasterlab.grader.limits.tell
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.Intake
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.Submissions
import rasterlab.grader.submission.receiveFields
import java.time.Instant
import java.time.InstantSource

/** Shows what there is to do, and where to hand it in. */
fun Route.exercisePages(
    accounts: Accounts,
    rules: CourseRules,
    exercises: Exercises,
    sheets: Sheets,
    hints: Hints,
    submissions: Submissions,
    intake: Intake,
    queue: GradingQueue,
    closed: (Identity) -> Set<String>,
    clock: InstantSource,
) {
    val page = ExercisePage(rules, exercises, sheets, hints, submissions, Formulas(), clock)
    get("/exercises") {
        val who = call.someone(accounts)
        val kept = closed(who)
        val shown = exercises.all.filter { it.id() !in kept }
        call.respondExercises(who, shown, kept.isNotEmpty(), rules, submissions, clock)
    }
    get("/exercises/{id}") {
        page.show(call, call.someone(accounts), exercises.named(call.parameters.getOrFail("id")))
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
        val form = HandedForm.of(exercise, call.receiveFields())
        if (form.again) return@post page.show(call, student, exercise, form)
        page.showAgain(call, student, exercise, form)
        val source = form.source()
        val accepted = intake.accept(student, exercise, source, form.once(source), form.late, form.percent)
        queue.ring(accepted.id)
        call.tell(accepted.allowance)
        call.respondRedirect("/submissions/${accepted.id}")
    }
}

/**
 * The way through the course, and how far a student has come on it.
 *
 * @param exams whether some exercises are kept for exams
 */
private suspend fun ApplicationCall.respondExercises(
    who: Identity,
    exercises: List<Exercise>,
    exams: Boolean,
    rules: CourseRules,
    submissions: Submissions,
    clock: InstantSource,
) {
    val texts = texts()
    val now = clock.instant()
    val held = rules.of(who)
    val bests = submissions.bestsOf(who)
    respondPage(texts, who, texts.say("exercises.title")) {
        if (exams) p("ways") { a("/exams") { +texts.say("exam.title") } }
        if (exercises.isEmpty()) p { +texts.say("exercises.none") }
        Chapter.of(exercises).forEach { chapter(texts, it, held, bests, now) }
    }
}

/** A topic: what prepares for its exercises, and these. */
private fun FlowContent.chapter(
    texts: PageTexts,
    chapter: Chapter,
    held: Map<String, ExerciseRules>,
    bests: Map<String, Int?>?,
    now: Instant,
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
                val rules = held[exercise.id()] ?: ExerciseRules()
                rules.opens?.takeIf { now < it }?.let { opens ->
                    span("state") { +texts.say("exercises.opens", texts.time(opens)) }
                }
                rules.due?.let { due ->
                    val said = if (now > due) "exercises.over" else "exercises.deadline"
                    span("state") { +texts.say(said, texts.time(due)) }
                }
                if (bests != null) span("state") { +state(texts, exercise, bests) }
            }
        }
    }
}

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
