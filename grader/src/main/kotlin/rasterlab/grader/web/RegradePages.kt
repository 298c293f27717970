package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import kotlinx.html.a
import kotlinx.html.div
import kotlinx.html.id
import kotlinx.html.p
import kotlinx.html.stream.createHTML
import rasterlab.exercises.Exercise
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.regrade.DECISIONS
import rasterlab.grader.regrade.Regrade
import rasterlab.grader.regrade.RegradeChoice
import rasterlab.grader.regrade.RegradeState
import rasterlab.grader.regrade.Regrades
import rasterlab.grader.regrade.regradeId
import rasterlab.grader.regrade.respondRegradeEvents
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Live

/** Lets an instructor grade again: begin it, watch it, see who gains and who loses, and decide. */
fun Route.regradePages(
    accounts: Accounts,
    courses: Courses,
    exercises: Exercises,
    regrades: Regrades,
    queue: GradingQueue,
    live: Live,
) {
    get("/instructor/courses/{course}/exercises/{id}/regrade") {
        val who = call.instructorHere(accounts)
        val desk = RegradeDesk(call.courseOf(courses), call.exerciseOf(exercises), regrades)
        desk.show(call, who, typed = null, refused = null)
    }
    post("/instructor/courses/{course}/exercises/{id}/regrade") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val desk = RegradeDesk(call.courseOf(courses), call.exerciseOf(exercises), regrades)
        val begun = desk.begin(call, who, call.receiveForm())
        queue.ring(begun.id)
        call.respondRedirect(regradeAddress(begun))
    }
    get("/instructor/regrades/{regrade}") {
        val who = call.instructorHere(accounts)
        call.respondRegrade(who, regrades, exercises, refused = null)
    }
    get("/instructor/regrades/{regrade}/fragment") {
        call.instructorHere(accounts)
        val texts = call.texts()
        val regrade = regrades.find(call.regradeId())
        call.respondFragment(
            createHTML(prettyPrint = false).div { regrade(texts, regrade, regrades, exercises.find(regrade.exercise)) },
        )
    }
    get("/instructor/regrades/{regrade}/events") {
        call.instructorHere(accounts)
        call.respondRegradeEvents(regrades, live)
    }
    for ((name, decide) in DECISIONS) {
        post("/instructor/regrades/{regrade}/$name") {
            call.requireOwnForm()
            val who = call.instructorHere(accounts)
            val id = regrades.find(call.regradeId()).id
            val again =
                FormAgain { status, code, added ->
                    call.respondRegrade(who, regrades, exercises, Refused(status, code, added(call.texts().language)))
                }
            call.attributes.put(FORM_AGAIN, again)
            val decided = regrades.decide(id, who.id, null)
            live.announce()
            call.respondRedirect(regradeAddress(decided))
        }
    }
}

internal fun regradeAddress(regrade: Regrade) = "/instructor/regrades/${regrade.id}"

private suspend fun ApplicationCall.respondRegrade(
    who: Identity.Instructor,
    regrades: Regrades,
    exercises: Exercises,
    refused: Refused?,
) {
    val texts = texts()
    val regrade = regrades.find(regradeId())
    val exercise = exercises.find(regrade.exercise)
    val title = texts.say("regrade.title", exercise?.title(texts.language) ?: regrade.exercise)
    respondPage(texts, who, title, refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p {
            a("/instructor/courses/${regrade.course}/exercises/${regrade.exercise}/regrade") {
                +texts.say("regrade.back")
            }
        }
        div {
            id = "live"
            attributes["aria-live"] = "polite"
            if (regrade.state == RegradeState.GRADING) {
                attributes["data-events"] = "${regradeAddress(regrade)}/events"
                attributes["data-fragment"] = "${regradeAddress(regrade)}/fragment"
            }
            regrade(texts, regrade, regrades, exercise)
        }
    }
}

/** The page where regrades of one exercise in one course begin. */
private class RegradeDesk(
    private val course: Course,
    private val exercise: Exercise,
    private val regrades: Regrades,
) {
    private val address = "${rulesAddress(course, exercise)}/regrade"

    /** Begins what the form asks for; where that is refused, the form is shown again as it was filled in. */
    fun begin(
        call: ApplicationCall,
        who: Identity.Instructor,
        form: Parameters,
    ): Regrade {
        val again =
            FormAgain { status, code, added ->
                show(call, who, form, Refused(status, code, added(call.texts().language)))
            }
        call.attributes.put(FORM_AGAIN, again)
        val choice = RegradeChoice.named(form["of"].orEmpty())
        val some = form.getAll("submission").orEmpty()
        return regrades.start(course, exercise, choice, some, form["dry"] == "yes", who.id, key = null)
    }

    suspend fun show(
        call: ApplicationCall,
        who: Identity.Instructor,
        typed: Parameters?,
        refused: Refused?,
    ) {
        val texts = call.texts()
        val heading = "${texts.say("regrade.heading")}: ${exercise.title(texts.language)} — ${course.name}"
        val graded = regrades.gradable(course, exercise.id())
        val before = regrades.ofCourse(course).items.filter { it.exercise == exercise.id() }
        call.respondPage(texts, who, heading, refused?.status ?: HttpStatusCode.OK) {
            refused?.let { problem(texts, it.status, it.code, it.details) }
            p { a(rulesAddress(course, exercise)) { +texts.say("regrade.rules") } }
            if (graded.isEmpty()) p { +texts.say("regrade.none") } else regradeForm(texts, address, graded, typed)
            if (before.isNotEmpty()) regradeTable(texts, before, exercise)
        }
    }
}
