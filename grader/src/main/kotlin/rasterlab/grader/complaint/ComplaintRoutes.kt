package rasterlab.grader.complaint

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.comment.CommentText
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.identity
import rasterlab.grader.course.staff
import rasterlab.grader.course.student
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.Rejection
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text
import rasterlab.grader.submission.Submissions

/** A complaint as it is told; students are not told the accounts of staff. */
@Serializable
private data class ToldComplaint(
    val id: String,
    val submission: String,
    val case: String,
    val current: Boolean,
    val text: String,
    val openedAt: String,
    val state: String,
    val answer: String?,
    val answeredBy: String?,
    val answeredAt: String?,
    val regrade: String?,
    val regradeState: String?,
)

@Serializable
private data class ListedComplaintAnswer(
    val student: String,
    val exercise: String,
    val attempt: Int,
    val complaint: ToldComplaint,
)

@Serializable
private data class CourseComplaintsAnswer(
    val complaints: List<ListedComplaintAnswer>,
    val next: String?,
)

/** Serves complaints to their students and to staff, inside `authenticate`. */
fun Route.complaints(
    submissions: Submissions,
    courses: Courses,
    complaints: ComplaintDesk,
) {
    get("/submissions/{id}/complaints") {
        val submission = submissions.seenBy(call.identity(), call.parameters.getOrFail("id"))
        val all = complaints.of(submission.id)
        call.respondPart(call.paging(Paging.WHOLE).of(all) { it.id }.map(::told))
    }
    post("/submissions/{id}/complaints") {
        val student = call.student()
        val submission = submissions.seenBy(student, call.parameters.getOrFail("id"))
        val (case, text) = call.receiveJson("case", "text") { it.anyText("case") to it.anyText("text") }
        val made = complaints.open(student, submission, case, CommentText.of(text), call.idempotencyKey())
        call.respondJson(told(made), Created)
    }
    patch("/submissions/{id}/complaints/{complaint}") {
        val who = call.staff()
        val submission = submissions.seenBy(who, call.parameters.getOrFail("id"))
        val sent =
            call.receiveJson("state", "text", "regrade") { body ->
                Triple(
                    accepts(body.anyText("state")),
                    CommentText.of(body.anyText("text")),
                    body.flag("regrade", false),
                )
            }
        val id = call.parameters.getOrFail("complaint")
        call.respondJson(told(complaints.answer(who, submission, id, sent.first, sent.second, sent.third)))
    }
    get("/courses/{course}/complaints") {
        call.staff()
        val asked = call.request.queryParameters["state"] ?: ComplaintState.OPEN.code
        if (asked !in STATES) throw Rejection.Malformed("state is '$asked', allowed are ${STATES.joinToString()}")
        val open = asked == ComplaintState.OPEN.code
        val part = complaints.ofCourse(call.course(courses).id, open, call.paging())
        call.linkNext(part)
        val listed = part.items.map { ListedComplaintAnswer(it.student, it.exercise, it.attempt, told(it.complaint)) }
        call.respondJson(CourseComplaintsAnswer(listed, part.next))
    }
}

private val STATES = listOf("open", "settled")

/** Whether a decision is that the student is right. */
fun accepts(decision: String): Boolean =
    when (decision) {
        ComplaintState.ACCEPTED.code -> true
        ComplaintState.DECLINED.code -> false
        else -> throw Rejection.Malformed("state is '$decision', allowed are accepted, declined")
    }

private fun told(one: CaseComplaint) =
    ToldComplaint(
        one.id,
        one.submission,
        one.case,
        one.current,
        one.text,
        one.openedAt.text(),
        one.state.code,
        one.answer?.text,
        one.answer?.name,
        one.answer?.at?.text(),
        one.regrade?.id,
        one.regrade?.state?.code,
    )
