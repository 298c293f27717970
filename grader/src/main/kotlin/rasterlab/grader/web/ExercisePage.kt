package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import kotlinx.html.FlowContent
import kotlinx.html.MAIN
import kotlinx.html.a
import kotlinx.html.article
import kotlinx.html.div
import kotlinx.html.h2
import kotlinx.html.id
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.unsafe
import rasterlab.exercises.Exercise
import rasterlab.exercises.formula.Formulas
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.exercise.starterFile
import rasterlab.grader.hint.Hints
import rasterlab.grader.hint.TakenHint
import rasterlab.grader.problem.LANGUAGES
import rasterlab.grader.rules.CountingPolicy
import rasterlab.grader.rules.CourseRules
import rasterlab.grader.rules.ExerciseRules
import rasterlab.grader.submission.HandedForm
import rasterlab.grader.submission.Listed
import rasterlab.grader.submission.Sheets
import rasterlab.grader.submission.Submissions
import rasterlab.grader.submission.TypedSheet
import java.time.Instant
import java.time.InstantSource

/** The page of one exercise: its statement, where to hand in, hints, and the attempts so far. */
internal class ExercisePage(
    private val rules: CourseRules,
    private val exercises: Exercises,
    private val sheets: Sheets,
    private val hints: Hints,
    private val submissions: Submissions,
    private val formulas: Formulas,
    private val clock: InstantSource,
) {
    /** @param form that was filled in before; null for an empty one */
    suspend fun show(
        call: ApplicationCall,
        who: Identity,
        exercise: Exercise,
        form: HandedForm? = null,
    ) = respond(call, stand(who, exercise, form), HttpStatusCode.OK, refused = null)

    /** Has [form] shown again, with all that it holds, where what [call] goes on to do with it is refused. */
    fun showAgain(
        call: ApplicationCall,
        who: Identity.StudentIdentity,
        exercise: Exercise,
        form: HandedForm,
    ) = call.attributes.put(
        FORM_AGAIN,
        FormAgain { status, code, added ->
            val refused = Refused(status, code, added(call.texts().language))
            respond(call, stand(who, exercise, form), status, refused)
        },
    )

    private fun stand(
        who: Identity,
        exercise: Exercise,
        form: HandedForm?,
    ): ExerciseStand {
        val sheet = sheets.next(who, exercise)
        // Answers typed to another sheet, as where this attempt was handed in meanwhile, belong to no question of this
        // one.
        val typed = form?.answers?.takeIf { it.sheet.seed() == sheet?.seed() }
        return ExerciseStand(
            who,
            exercise,
            sheet?.let { typed ?: TypedSheet(exercise, it, emptyMap()) },
            if (who is Identity.StudentIdentity) hints.taken(who, exercise) else emptyList(),
            if (who is Identity.StudentIdentity) submissions.ofStudent(who.id, exercise.id()) else null,
            rules.of(who)[exercise.id()] ?: ExerciseRules(),
            if (who is Identity.StudentIdentity) rules.shows(who.id, exercise.id()) else null,
            clock.instant(),
            form,
        )
    }

    private suspend fun respond(
        call: ApplicationCall,
        stand: ExerciseStand,
        status: HttpStatusCode,
        refused: Refused?,
    ) {
        val texts = call.texts()
        call.respondPage(texts, stand.who, stand.exercise.title(texts.language), status, stand.filled()) {
            plan(texts, stand)
            div("columns wide") {
                article("card statement") {
                    val statement = stand.exercise.statement(texts.language).withoutTitle()
                    val html =
                        markdownAsHtml(statement, formulas, texts.language) {
                            stand.exercise.picture(it, texts.language)
                        }
                    unsafe { +html }
                    if (stand.mine != null) wayDown(texts)
                }
                section { work(texts, stand, refused) }
            }
            if (stand.mine != null) editor()
        }
    }

    /** Leads to the form where that stands below the statement. */
    private fun FlowContent.wayDown(texts: PageTexts) =
        p("way-down") { a("#hand-in", classes = "button") { +"${texts.say("exercise.submit.do")} ↓" } }

    private fun FlowContent.work(
        texts: PageTexts,
        stand: ExerciseStand,
        refused: Refused?,
    ) {
        val exercise = stand.exercise
        div("card") {
            id = "hand-in"
            p {
                val starter = "/exercises/${exercise.id()}/starter"
                val words = if (stand.sheet == null) "exercise.starter" else "exercise.sheet"
                a(starter) { +"${texts.say(words)} (${exercise.starterFile()})" }
            }
            if (stand.mine != null) handIn(texts, stand, refused)
        }
        if (stand.mine == null) return
        if (exercise.hints().isNotEmpty()) hintSteps(texts, exercise, stand.taken, formulas)
        h2 { +texts.say("exercise.mine") }
        if (stand.mine.isEmpty()) {
            p { +texts.say("exercise.mine.none") }
        } else {
            attemptTable(texts, exercises, stand.mine)
            if (exercise.form() == Exercise.TaskKind.WRITE) {
                p { a("/exercises/${exercise.id()}/front") { +texts.say("front.link") } }
            }
            if (stand.rules.policy == CountingPolicy.CHOSEN) choice(texts, stand.mine)
        }
    }
}

/**
 * Where somebody stands with an exercise.
 *
 * @param sheet that the next attempt answers, with what is typed by now; null where there is none
 * @param mine the attempts so far; null for somebody who hands nothing in
 * @param rules that hold for them, at the moment [now]
 * @param shows the moment after which hidden cases are shown; null for never
 * @param form that was refused, or null
 */
internal class ExerciseStand(
    val who: Identity,
    val exercise: Exercise,
    val sheet: TypedSheet?,
    val taken: List<TakenHint>,
    val mine: List<Listed>?,
    val rules: ExerciseRules,
    val shows: Instant?,
    val now: Instant,
    val form: HandedForm?,
)

/** Why a form was not taken. */
internal class Refused(
    val status: HttpStatusCode,
    val code: String,
    val details: List<String>,
)

private fun MAIN.plan(
    texts: PageTexts,
    stand: ExerciseStand,
) {
    val plan = stand.exercise.points()
    p("plan") {
        +texts.say("exercises.points", plan.total())
        if (stand.exercise.form() == Exercise.TaskKind.WRITE) {
            +" — "
            +texts.say("exercise.plan", plan.accuracy(), plan.stability(), plan.speed())
        }
    }
    val said = texts.rules(stand.rules, stand.now, stand.mine.orEmpty().size)
    if (said.isNotEmpty()) p("plan") { +(said + listOfNotNull(showing(texts, stand))).joinToString(" ") }
}

/** Tells from when on hidden cases are shown, as long as they are not. */
private fun showing(
    texts: PageTexts,
    stand: ExerciseStand,
): String? {
    val shows = stand.shows?.takeIf { stand.now <= it && stand.exercise.hidesCases() } ?: return null
    return when (shows) {
        stand.rules.due -> texts.say("exercise.due.hidden")

        stand.rules.closes -> texts.say("exercise.shows", texts.time(shows))

        // The moment is an extension of somebody else, who is nobody's business.
        else -> texts.say("exercise.shows.later")
    }
}

/** The page shows the title itself. */
private fun String.withoutTitle() = if (startsWith("# ")) substringAfter('\n', "") else this

/** The address of a picture of the statement, of which a language may have one of its own. */
private fun Exercise.picture(
    name: String,
    language: String,
): String {
    val asked = if (language == LANGUAGES.first()) "" else "?lang=$language"
    return "/exercises/${id()}/pictures/$name$asked"
}
