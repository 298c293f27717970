package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.http.Parameters
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondRedirect
import io.ktor.server.routing.Route
import io.ktor.server.routing.get
import io.ktor.server.routing.post
import io.ktor.server.util.getOrFail
import kotlinx.html.FlowContent
import kotlinx.html.FlowOrPhrasingContent
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.SELECT
import kotlinx.html.a
import kotlinx.html.button
import kotlinx.html.details
import kotlinx.html.div
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.option
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.select
import kotlinx.html.span
import kotlinx.html.summary
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Course
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Identity
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffMember
import rasterlab.grader.course.StaffRole

private const val ADDRESS = "/instructor/staff"

/** Shows an instructor who teaches, and lets them add or rename somebody, make a new token, and take access away. */
fun Route.staffPages(
    accounts: Accounts,
    staff: Staff,
    courses: Courses,
) {
    val desk = StaffDesk(staff, courses)
    get(ADDRESS) {
        call.respondStaff(call.instructorHere(accounts), desk, typed = null, refused = null)
    }
    post(ADDRESS) {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val form = call.receiveForm()
        call.showStaffAgain(who, desk, form)
        val name = Name.of(form["name"].orEmpty())
        val role = StaffRole.of(form["role"].orEmpty())
        val made = staff.add(name, role, who.id, key = null, form.course())
        call.respondToken(who, name.text, made.token, ADDRESS, "staff.back")
    }
    post("$ADDRESS/{staff}/token") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val made = staff.renew(call.parameters.getOrFail("staff"), who.id, key = null)
        call.respondToken(who, call.texts().nameOf(staff.find(made.id)), made.token, ADDRESS, "staff.back")
    }
    post("$ADDRESS/{staff}/name") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        call.showStaffAgain(who, desk, typed = null)
        val name = Name.of(call.receiveForm()["name"].orEmpty())
        staff.rename(call.parameters.getOrFail("staff"), name, who.id)
        call.respondRedirect(ADDRESS)
    }
    post("$ADDRESS/{staff}/course") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        call.showStaffAgain(who, desk, typed = null)
        staff.assign(call.parameters.getOrFail("staff"), call.receiveForm().course(), who.id)
        call.respondRedirect(ADDRESS)
    }
    post("$ADDRESS/{staff}/revoke") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        call.showStaffAgain(who, desk, typed = null)
        staff.revoke(call.parameters.getOrFail("staff"), who.id)
        call.respondRedirect(ADDRESS)
    }
}

private class StaffDesk(
    val staff: Staff,
    val courses: Courses,
)

/** The single course that was chosen; null for all. */
private fun Parameters.course(): String? = get("course")?.takeIf { it.isNotEmpty() }

/** Has the page shown again where what the call goes on to do is refused. */
private fun ApplicationCall.showStaffAgain(
    who: Identity.Instructor,
    desk: StaffDesk,
    typed: Parameters?,
) = attributes.put(
    FORM_AGAIN,
    FormAgain { status, code, added ->
        respondStaff(who, desk, typed, Refused(status, code, added(texts().language)))
    },
)

private suspend fun ApplicationCall.respondStaff(
    who: Identity.Instructor,
    desk: StaffDesk,
    typed: Parameters?,
    refused: Refused?,
) {
    val texts = texts()
    val courses = desk.courses.all()
    respondPage(texts, who, texts.say("staff.title"), refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("staff.rights") }
        memberTable(texts, who, desk.staff.all(), courses)
        section("card apart") { addition(texts, typed, courses) }
        p { a("/instructor/audit") { +texts.say("audit.open") } }
    }
}

private fun FlowContent.memberTable(
    texts: PageTexts,
    who: Identity.Instructor,
    members: List<StaffMember>,
    courses: List<Course>,
) {
    val columns =
        listOf<Pair<String, FlowContent.(StaffMember) -> Unit>>(
            "name" to { one ->
                val name = texts.nameOf(one)
                +if (one.id == who.id) texts.say("staff.you", name) else name
                naming(texts, one)
            },
            "role" to { +texts.say("staff.role.${it.role.code}") },
            "course" to { one ->
                +(one.course?.name ?: texts.say("staff.course.all"))
                assigning(texts, one, courses)
            },
            "made" to { moment(texts, it.madeAt) },
            "used" to { one -> one.lastUsedAt?.let { moment(texts, it) } ?: +texts.say("staff.never") },
            "entry" to { access(texts, it) },
        ).map { (name, content) -> texts.say("staff.column.$name", texts.zoneName) to content }
    stacked(texts.say("staff.title"), columns, members)
}

private fun FlowContent.naming(
    texts: PageTexts,
    one: StaffMember,
) = details {
    summary {
        attributes["aria-label"] = "${texts.say("staff.rename")}: ${texts.nameOf(one)}"
        +texts.say("staff.rename")
    }
    form("$ADDRESS/${one.id}/name", method = FormMethod.post) {
        div("ways") {
            input(InputType.text, name = "name") {
                value = one.name
                required = true
                attributes["autocomplete"] = "off"
                attributes["aria-label"] = "${texts.say("staff.name")}: ${texts.nameOf(one)}"
            }
            button(classes = "plain") { +texts.say("staff.rename.do") }
        }
    }
}

private fun FlowContent.assigning(
    texts: PageTexts,
    one: StaffMember,
    courses: List<Course>,
) = details {
    summary {
        attributes["aria-label"] = "${texts.say("staff.assign")}: ${texts.nameOf(one)}"
        +texts.say("staff.assign")
    }
    form("$ADDRESS/${one.id}/course", method = FormMethod.post) {
        div("ways") {
            courseChoice(texts, courses, one.course?.id) {
                attributes["aria-label"] = "${texts.say("staff.column.course")}: ${texts.nameOf(one)}"
            }
            button(classes = "plain") { +texts.say("staff.assign.do") }
        }
    }
}

/** @param chosen id of the single course; null for all */
private fun FlowOrPhrasingContent.courseChoice(
    texts: PageTexts,
    courses: List<Course>,
    chosen: String?,
    named: SELECT.() -> Unit = {},
) = select {
    name = "course"
    named()
    option {
        value = ""
        selected = chosen == null
        +texts.say("staff.course.all")
    }
    courses.forEach { course ->
        option {
            value = course.id
            selected = course.id == chosen
            +"${course.name} (${course.code})"
        }
    }
}

private fun FlowContent.access(
    texts: PageTexts,
    one: StaffMember,
) {
    val name = texts.nameOf(one)
    one.revokedAt?.let { p { +texts.say("staff.revoked", texts.time(it)) } }
    div("ways") {
        newTokenButton(texts, "$ADDRESS/${one.id}/token", name)
        if (one.revokedAt == null) {
            form("$ADDRESS/${one.id}/revoke", method = FormMethod.post) {
                button(classes = "plain") {
                    attributes["aria-label"] = "${texts.say("staff.revoke")}: $name"
                    +texts.say("staff.revoke")
                }
            }
        }
    }
}

private fun FlowContent.addition(
    texts: PageTexts,
    typed: Parameters?,
    courses: List<Course>,
) {
    h2 { +texts.say("staff.add") }
    form(ADDRESS, method = FormMethod.post) {
        label {
            span { +texts.say("staff.name") }
            input(InputType.text, name = "name") {
                value = typed?.get("name").orEmpty()
                required = true
                attributes["autocomplete"] = "off"
            }
        }
        label {
            span { +texts.say("staff.column.role") }
            select {
                name = "role"
                StaffRole.entries.reversed().forEach { role ->
                    option {
                        value = role.code
                        selected = typed?.get("role") == role.code
                        +texts.say("staff.role.${role.code}")
                    }
                }
            }
        }
        label {
            span { +texts.say("staff.column.course") }
            courseChoice(texts, courses, typed?.course())
        }
        button { +texts.say("staff.add.do") }
    }
}

private fun PageTexts.nameOf(one: StaffMember): String = one.name.ifEmpty { say("staff.unnamed") }
