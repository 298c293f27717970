package rasterlab.grader.regrade

import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode.Companion.Accepted
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.header
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import rasterlab.exercises.json.JsonFields
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.flag
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.report.onEachChange
import rasterlab.grader.report.respondEvents
import rasterlab.grader.storage.text
import rasterlab.grader.submission.GradingQueue
import rasterlab.grader.submission.Live

@Serializable
private data class RegradeAnswer(
    val regrade: String,
    val course: String,
    val exercise: String,
    val revision: String,
    val of: String,
    val case: String?,
    val dry: Boolean,
    val state: String,
    val begunAt: String,
    val settledAt: String?,
    val total: Int,
    val done: Int,
    val failed: Int,
)

@Serializable
private data class PointsAnswer(
    val verdict: String,
    val points: Int,
    val of: Int,
)

@Serializable
private data class CaseStandAnswer(
    val verdict: String,
    val points: Int,
)

@Serializable
private data class CaseChangeAnswer(
    val name: String,
    val before: CaseStandAnswer?,
    val after: CaseStandAnswer?,
)

@Serializable
private data class ChangeAnswer(
    val submission: String,
    val student: String,
    val name: String,
    val attempt: Int,
    val before: PointsAnswer,
    val after: PointsAnswer?,
    val cases: List<CaseChangeAnswer>,
)

@Serializable
private data class WholeRegradeAnswer(
    val regrade: RegradeAnswer,
    val changes: List<ChangeAnswer>,
)

/** Lets instructors grade again, inside `authenticate`; `?dry=true` lets nothing count until it is accepted. */
fun Route.regrades(
    courses: Courses,
    exercises: Exercises,
    regrades: Regrades,
    queue: GradingQueue,
    live: Live,
) {
    post("/courses/{course}/exercises/{id}/regrade") {
        val instructor = call.instructor()
        val exercise = exercises.named(call.parameters.getOrFail("id"))
        val dry = call.flag("dry")
        val (choice, some) = call.receiveJson("of", "submissions", read = ::chosen)
        val course = call.course(courses)
        val begun = regrades.start(course, exercise, choice, some, dry, instructor.id, call.idempotencyKey())
        queue.ring(begun.id)
        call.response.header(HttpHeaders.Location, "/api/v1/regrades/${begun.id}")
        call.respondJson(answer(begun), Accepted)
    }
    get("/courses/{course}/regrades") {
        call.instructor()
        val part = regrades.ofCourse(call.course(courses), call.paging(usual = Regrades.LISTED))
        call.respondPart(part.map(::answer))
    }
    get("/regrades/{regrade}") {
        call.instructor()
        call.respondJson(whole(regrades, regrades.find(call.regradeId())))
    }
    get("/regrades/{regrade}/events") {
        call.instructor()
        call.respondRegradeEvents(regrades, live)
    }
    for ((name, decide) in DECISIONS) {
        post("/regrades/{regrade}/$name") {
            val instructor = call.instructor()
            val decided = regrades.decide(call.regradeId(), instructor.id, call.idempotencyKey())
            live.announce()
            call.respondJson(answer(decided))
        }
    }
}

/** The ways to decide on a regrade, by the word that asks for each. */
val DECISIONS: Map<String, Regrades.(String, String, String?) -> Regrade> =
    mapOf("accept" to Regrades::accept, "discard" to Regrades::discard, "undo" to Regrades::undo)

fun ApplicationCall.regradeId(): String = parameters.getOrFail("regrade")

/** Answers with the progress of a regrade, `changed` at each step and `done` when nothing is left to grade. */
suspend fun ApplicationCall.respondRegradeEvents(
    regrades: Regrades,
    live: Live,
) {
    val id = regradeId()
    regrades.find(id)
    respondEvents {
        var told: Regrade? = null
        onEachChange(live, submission = null) {
            val now = regrades.find(id)
            val ends = now.state != RegradeState.GRADING
            if (now != told) send(Json.encodeToString(answer(now)), event = if (ends) "done" else "changed")
            told = now
            !ends
        }
    }
}

/** Which submissions the body asks for: all where it says nothing. */
private fun chosen(body: JsonFields): Pair<RegradeChoice, List<String>> {
    if (!body.has("submissions")) {
        val choice = RegradeChoice.named(if (body.has("of")) body.anyText("of") else RegradeChoice.ALL.code)
        return choice to emptyList()
    }
    if (body.has("of")) throw Rejection.Malformed("the body: expected of or submissions, not both")
    return RegradeChoice.SOME to body.texts("submissions")
}

private fun answer(regrade: Regrade) =
    RegradeAnswer(
        regrade.id,
        regrade.course,
        regrade.exercise,
        regrade.revision,
        regrade.choice.code,
        regrade.case,
        regrade.dry,
        regrade.state.code,
        regrade.begunAt.text(),
        regrade.settledAt?.text(),
        regrade.total,
        regrade.done,
        regrade.failed,
    )

/** The regrade with its changes, which there are none of before all is graded. */
private fun whole(
    regrades: Regrades,
    regrade: Regrade,
): WholeRegradeAnswer {
    val changes = if (regrade.state == RegradeState.GRADING) emptyList() else regrades.changes(regrade)
    return WholeRegradeAnswer(answer(regrade), changes.map(::answer))
}

private fun answer(change: RegradeChange) =
    ChangeAnswer(
        change.submission,
        change.student,
        change.name,
        change.attempt,
        answer(change.before),
        change.after?.let(::answer),
        change.cases.map { CaseChangeAnswer(it.name, it.before?.let(::answer), it.after?.let(::answer)) },
    )

private fun answer(points: RegradePoints) = PointsAnswer(points.verdict, points.points, points.of)

private fun answer(case: Pair<String, Int>) = CaseStandAnswer(case.first, case.second)
