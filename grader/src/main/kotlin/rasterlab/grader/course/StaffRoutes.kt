package rasterlab.grader.course

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.storage.text

@Serializable
private data class StaffAnswer(
    val staff: String,
    val name: String,
    val role: String,
    val madeAt: String,
    val lastUsedAt: String?,
    val revokedAt: String?,
)

@Serializable
private data class StaffTokenAnswer(
    val staff: String,
    val token: String,
)

@Serializable
private data class AuditAnswer(
    val entries: List<AuditEntryAnswer>,
    val next: String?,
)

@Serializable
private data class AuditEntryAnswer(
    val id: String,
    val at: String,
    val by: String,
    val byName: String,
    val course: String?,
    val action: String,
    val subject: String,
    val subjectName: String?,
    val detail: String,
)

/** Serves who teaches, and what they changed, to instructors, inside `authenticate`. */
fun Route.staff(
    staff: Staff,
    audit: Audit,
) {
    get("/staff") {
        call.instructor()
        call.respondJson(staff.all().map(::answer))
    }
    post("/staff") {
        val instructor = call.instructor()
        val (name, role) = call.receiveJson("name", "role") { it.anyText("name") to it.anyText("role") }
        val made = staff.add(Name.of(name), StaffRole.of(role), instructor.id, call.idempotencyKey())
        call.respondJson(StaffTokenAnswer(made.id, made.token), Created)
    }
    post("/staff/{staff}/token") {
        val instructor = call.instructor()
        val made = staff.renew(call.parameters.getOrFail("staff"), instructor.id, call.idempotencyKey())
        call.respondJson(StaffTokenAnswer(made.id, made.token), Created)
    }
    patch("/staff/{staff}") {
        val instructor = call.instructor()
        val name = Name.of(call.receiveJson("name") { it.anyText("name") })
        call.respondJson(answer(staff.rename(call.parameters.getOrFail("staff"), name, instructor.id)))
    }
    delete("/staff/{staff}") {
        val instructor = call.instructor()
        call.respondJson(answer(staff.revoke(call.parameters.getOrFail("staff"), instructor.id)))
    }
    get("/audit") {
        call.instructor()
        val page = audit.page(call.request.queryParameters["before"])
        call.respondJson(AuditAnswer(page.entries.map(::answer), page.next))
    }
}

private fun answer(one: StaffMember) =
    StaffAnswer(
        one.id,
        one.name,
        one.role.code,
        one.madeAt.text(),
        one.lastUsedAt?.text(),
        one.revokedAt?.text(),
    )

private fun answer(one: AuditEntry) =
    AuditEntryAnswer(
        one.id,
        one.notedAt.text(),
        one.by,
        one.byName,
        one.course,
        one.action,
        one.subject,
        one.subjectName,
        one.detail,
    )
