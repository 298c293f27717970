package rasterlab.grader.lti

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.course.Courses
import rasterlab.grader.course.course
import rasterlab.grader.course.instructor
import rasterlab.grader.course.staff
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text

@Serializable
private data class PlatformAnswer(
    val platform: String,
    val name: String,
    val issuer: String,
    val clientId: String,
    val deployment: String,
    val loginUrl: String,
    val tokenUrl: String,
    val keysUrl: String,
    val makesStaff: Boolean,
    val addedAt: String,
)

@Serializable
private data class ScoreAnswer(
    val student: String,
    val name: String,
    val platform: String,
    val exercise: String,
    val points: Int?,
    val of: Int,
    val state: String,
    val sentPoints: Int?,
    val sentAt: String?,
    val dueAt: String?,
    val tries: Int,
    val fault: String?,
)

@Serializable
private data class WokenAnswer(
    val scores: Int,
)

@Serializable
private data class KeyAnswer(
    val id: String,
    val until: String?,
)

/** Serves registrations of platforms and this server's key to instructors, inside `authenticate`, and how scores stand there to staff. */
fun Route.lti(
    platforms: Platforms,
    key: ToolKey,
    courses: Courses,
    states: ScoreStates,
) {
    get("/lti/platforms") {
        call.instructor()
        call.respondPart(call.paging(Paging.WHOLE).of(platforms.all()) { it.id }.map(::answer))
    }
    post("/lti/platforms") {
        val instructor = call.instructor()
        call.respondJson(
            answer(platforms.add(call.form(), instructor.id, call.idempotencyKey())),
            HttpStatusCode.Created,
        )
    }
    delete("/lti/platforms/{platform}") {
        val instructor = call.instructor()
        call.respondJson(answer(platforms.remove(call.parameters.getOrFail("platform"), instructor.id)))
    }
    get("/lti/key") {
        call.instructor()
        call.respondJson(key.published().map(::answer))
    }
    post("/lti/key") {
        key.renew(call.instructor().id, call.idempotencyKey())
        call.respondJson(key.published().map(::answer), HttpStatusCode.Created)
    }
    get("/courses/{course}/lti/scores") {
        call.staff()
        val course = call.course(courses).id
        val paging = call.paging(Paging.WHOLE)
        val all = if (paging.isPart) states.byStudent(course) else states.of(course, most = Paging.WHOLE)
        call.respondPart(paging.of(all) { it.id }.map(::answer))
    }
    post("/courses/{course}/lti/scores/send") {
        val instructor = call.instructor()
        call.respondJson(WokenAnswer(states.sendNow(call.course(courses).id, instructor.id)))
    }
}

private suspend fun ApplicationCall.form(): PlatformForm =
    receiveJson("name", "issuer", "clientId", "deployment", "loginUrl", "tokenUrl", "keysUrl", "makesStaff") {
        PlatformForm(
            it.text("name"),
            it.text("issuer"),
            it.text("clientId"),
            it.text("deployment"),
            it.text("loginUrl"),
            it.text("tokenUrl"),
            it.text("keysUrl"),
            it.flag("makesStaff", false),
        )
    }

private fun answer(one: PublishedKey) = KeyAnswer(one.id, one.until?.text())

private fun answer(one: Platform) =
    PlatformAnswer(
        one.id,
        one.name,
        one.issuer,
        one.clientId,
        one.deployment,
        "${one.login}",
        "${one.token}",
        "${one.keys}",
        one.makesStaff,
        one.addedAt.text(),
    )

private fun answer(one: ScoreState) =
    ScoreAnswer(
        one.student,
        one.studentName,
        one.platform,
        one.exercise,
        one.points,
        one.of,
        one.code,
        one.sentPoints,
        one.sentAt?.text(),
        one.dueAt?.text(),
        one.tries,
        one.fault,
    )
