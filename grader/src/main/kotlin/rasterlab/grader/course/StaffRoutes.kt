package rasterlab.grader.course

import io.ktor.http.HttpStatusCode.Companion.Created
import io.ktor.server.routing.Route
import io.ktor.server.routing.delete
import io.ktor.server.routing.get
import io.ktor.server.routing.patch
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.serialization.Serializable
import rasterlab.exercises.json.JsonFields
import rasterlab.grader.problem.Paging
import rasterlab.grader.problem.idempotencyKey
import rasterlab.grader.problem.linkNext
import rasterlab.grader.problem.paging
import rasterlab.grader.problem.receiveJson
import rasterlab.grader.problem.respondJson
import rasterlab.grader.problem.respondPart
import rasterlab.grader.storage.text

@Serializable
private data class StaffAnswer(
    val staff: String,
    val name: String,
    val role: String,
    val course: String?,
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

/** @param course id or code of a single one; null for all */
private class Assigned(
    val course: String?,
)

/** Serves who teaches, and what they changed, to instructors, inside `authenticate`. */
fun Route.staff(
    staff: Staff,
    audit: Audit,
) {
    get("/staff") {
        call.instructor()
        call.respondPart(call.paging(Paging.WHOLE).of(staff.all()) { it.id }.map(::answer))
    }
    post("/staff") {
        val instructor = call.instructor()
        val (name, role, course) =
            call.receiveJson("name", "role", "course") {
                Triple(it.anyText("name"), it.anyText("role"), it.courseOrAll())
            }
        val made = staff.add(Name.of(name), StaffRole.of(role), instructor.id, call.idempotencyKey(), course)
        call.respondJson(StaffTokenAnswer(made.id, made.token), Created)
    }
    post("/staff/{staff}/token") {
        val instructor = call.instructor()
        val made = staff.renew(call.parameters.getOrFail("staff"), instructor.id, call.idempotencyKey())
        call.respondJson(StaffTokenAnswer(made.id, made.token), Created)
    }
    patch("/staff/{staff}") {
        val instructor = call.instructor()
        val id = call.parameters.getOrFail("staff")
        val (name, assigned) =
            call.receiveJson("name", "course") {
                (if (it.has("name")) Name.of(it.anyText("name")) else null) to
                    (if (it.has("course")) Assigned(it.courseOrAll()) else null)
            }
        val changed =
            when {
                name != null && assigned != null -> staff.renameAndAssign(id, name, assigned.course, instructor.id)
                name != null -> staff.rename(id, name, instructor.id)
                assigned != null -> staff.assign(id, assigned.course, instructor.id)
                else -> staff.find(id)
            }
        call.respondJson(answer(changed))
    }
    delete("/staff/{staff}") {
        val instructor = call.instructor()
        call.respondJson(answer(staff.revoke(call.parameters.getOrFail("staff"), instructor.id)))
    }
    get("/audit") {
        call.instructor()
        val part = audit.part(call.paging(former = BEFORE))
        call.linkNext(part, former = BEFORE)
        call.respondJson(AuditAnswer(part.items.map(::answer), part.next))
    }
}

/** The name that `after` had in the addresses of the audit. */
private const val BEFORE = "before"

/** The id or code of a single course; null for all, which is also meant where nothing is said. */
private fun JsonFields.courseOrAll(): String? = if (!has("course") || tree("course").isNull) null else anyText("course")

private fun answer(one: StaffMember) =
    StaffAnswer(
        one.id,
        one.name,
        one.role.code,
        one.course?.id,
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
