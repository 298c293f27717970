package rasterlab.grader.adjustment

import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.staff
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.typed
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submissions

@Serializable
private data class AdjustmentAnswer(
    val id: String,
    val points: Int,
    val reason: String,
    val before: Int,
    val by: String,
    val givenAt: String,
    val revokedBy: String?,
    val revokedAt: String?,
)

@Serializable
private data class AdjustedAnswer(
    val submission: String,
    val total: Int?,
    val of: Int?,
    val adjustments: List<AdjustmentAnswer>,
)

/** Lets staff give and take points, inside `authenticate`. */
fun Route.adjustments(
    submissions: Submissions,
    adjustments: Adjustments,
) {
    get("/submissions/{id}/points") {
        call.staff()
        call.respondAdjusted(submissions, adjustments)
    }
    patch("/submissions/{id}/points") {
        val staff = call.staff()
        val id = submissions.seenBy(staff, call.parameters.getOrFail("id")).id
        val (points, reason) =
            call.receiveJson("points", "reason") { typed("points", it.tree("points")) to it.anyText("reason") }
        adjustments.give(id, points, reason, staff.id, call.idempotencyKey())
        call.respondAdjusted(submissions, adjustments)
    }
    delete("/submissions/{id}/points/{adjustment}") {
        val staff = call.staff()
        val id = submissions.seenBy(staff, call.parameters.getOrFail("id")).id
        adjustments.revoke(id, call.parameters.getOrFail("adjustment"), staff.id)
        call.respondAdjusted(submissions, adjustments)
    }
}

private suspend fun ApplicationCall.respondAdjusted(
    submissions: Submissions,
    adjustments: Adjustments,
) {
    val id = submissions.seenBy(staff(), parameters.getOrFail("id")).id
    val listed = submissions.listed(id)
    respondJson(AdjustedAnswer(id, listed?.points, listed?.of, adjustments.of(id).map(::answer)))
}

private fun answer(one: Adjustment) =
    AdjustmentAnswer(
        one.id,
        one.points,
        one.reason,
        one.before,
        one.by,
        one.givenAt.text(),
        one.revokedBy,
        one.revokedAt?.text(),
    )
