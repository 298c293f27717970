package rasterlab.grader.course

import io.ktor.http.ContentType
import io.ktor.server.routing.Route
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.bodyType
import rasterlab.grader.problem.flag
import rasterlab.grader.problem.receiveAtMost
import rasterlab.grader.problem.respondJson

/** The most bytes that a roster may have. */
internal const val ROSTER_BYTES = 1 shl 20

@Serializable
private data class AddedAnswer(
    val student: String?,
    val name: String,
    val token: String?,
)

@Serializable
private data class ChangeAnswer(
    val field: String,
    val from: String?,
    val to: String,
)

@Serializable
private data class CorrectedAnswer(
    val student: String,
    val from: String,
    val to: String,
    val fields: List<String>,
    val changes: List<ChangeAnswer>,
)

@Serializable
private data class MissingAnswer(
    val student: String,
    val name: String,
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
    val id = call.parameters.getOrFail("course")
    val dry = call.flag("dry")
    call.bodyType(ContentType.Text.CSV)
    val course = courses.find(id) ?: throw Rejection.UnknownCourse(id)
    val change = roster.apply(course, call.receiveAtMost(ROSTER_BYTES), dry, instructor.id)
    call.respondJson(
        RosterAnswer(
            dry,
            change.added.map { AddedAnswer(it.student, it.name, it.token) },
            change.corrected.map(::corrected),
            change.unchanged,
            change.missing.map { MissingAnswer(it.id, it.shownName) },
            change.unused,
        ),
    )
}

private fun corrected(one: RosterCorrection) =
    CorrectedAnswer(
        one.student,
        one.from,
        one.to,
        one.changes.map { it.field },
        one.changes.map { ChangeAnswer(it.field, it.from, it.to) },
    )
