package rasterlab.grader.course

import io.ktor.http.ContentType
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import kotlinx.serialization.Serializable
import rasterlab.grader.problem.bodyType
import rasterlab.grader.problem.flag
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.receiveAtMost
import rasterlab.grader.problem.respondJson

/** The most bytes that a roster may have. */
internal const val ROSTER_BYTES = 1 shl 20

@Serializable
private data class AddedAnswer(
    val student: String?,
    val name: String,
    val idNumber: String?,
    val email: String?,
    val token: String?,
)

@Serializable
private data class RosterChangeAnswer(
    val field: String,
    val from: String?,
    val to: String,
)

@Serializable
private data class CorrectedAnswer(
    val student: String,
    val from: String,
    val to: String,
    val idNumber: String?,
    val email: String?,
    val fields: List<String>,
    val changes: List<RosterChangeAnswer>,
)

@Serializable
private data class MissingAnswer(
    val student: String,
    val name: String,
    val idNumber: String?,
    val email: String?,
)

@Serializable
private data class RosterAnswer(
    val dry: Boolean,
    val added: List<AddedAnswer>,
    val corrected: List<CorrectedAnswer>,
    val unchanged: Int,
    val missing: List<MissingAnswer>,
    val unused: List<String>,
)

/** Takes rosters from instructors, inside `authenticate`; `?dry=true` says what would change, and changes nothing. */
fun Route.roster(
    courses: Courses,
    roster: RosterImport,
) = post("/courses/{course}/roster") {
    val instructor = call.instructor()
    val dry = call.flag("dry")
    call.bodyType(ContentType.Text.CSV)
    val change =
        roster.apply(
            call.course(courses),
            call.receiveAtMost(ROSTER_BYTES),
            dry,
            instructor.id,
            call.idempotencyKey(),
        )
    call.respondJson(
        RosterAnswer(
            dry,
            change.added.map(::added),
            change.corrected.map(::corrected),
            change.unchanged,
            change.missing.map { MissingAnswer(it.id, it.shownName, it.fields.idNumber, it.fields.email) },
            change.unused,
        ),
    )
}

private fun added(one: RosterAddition) =
    AddedAnswer(one.student, one.name, one.known.idNumber, one.known.email, one.token)

private fun corrected(one: RosterCorrection) =
    CorrectedAnswer(
        one.student,
        one.from,
        one.to,
        one.known.idNumber,
        one.known.email,
        one.changes.map { it.field },
        one.changes.map { RosterChangeAnswer(it.field, it.from, it.to) },
    )
