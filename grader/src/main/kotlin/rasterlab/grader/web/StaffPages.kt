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
import kotlinx.html.FormMethod
import kotlinx.html.InputType
import kotlinx.html.ThScope
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
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.grader.course.Accounts
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
) {
    get(ADDRESS) {
        call.respondStaff(call.instructorHere(accounts), staff, typed = null, refused = null)
    }
    post(ADDRESS) {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val form = call.receiveForm()
        call.showStaffAgain(who, staff, form)
        val name = Name.of(form["name"].orEmpty())
        val made = staff.add(name, StaffRole.of(form["role"].orEmpty()), who.id, key = null)
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
        call.showStaffAgain(who, staff, typed = null)
        val name = Name.of(call.receiveForm()["name"].orEmpty())
        staff.rename(call.parameters.getOrFail("staff"), name, who.id)
        call.respondRedirect(ADDRESS)
    }
    post("$ADDRESS/{staff}/revoke") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        call.showStaffAgain(who, staff, typed = null)
        staff.revoke(call.parameters.getOrFail("staff"), who.id)
        call.respondRedirect(ADDRESS)
    }
}

/** Has the page shown again where what the call goes on to do is refused. */
private fun ApplicationCall.showStaffAgain(
    who: Identity.Instructor,
    staff: Staff,
    typed: Parameters?,
) = attributes.put(
    FORM_AGAIN,
    FormAgain { status, code, added ->
        respondStaff(who, staff, typed, Refused(status, code, added(texts().language)))
    },
)

private suspend fun ApplicationCall.respondStaff(
    who: Identity.Instructor,
    staff: Staff,
    typed: Parameters?,
    refused: Refused?,
) {
    val texts = texts()
    respondPage(texts, who, texts.say("staff.title"), refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("staff.rights") }
        memberTable(texts, who, staff.all())
        section("card apart") { addition(texts, typed) }
        p { a("/instructor/audit") { +texts.say("audit.open") } }
    }
}

private fun FlowContent.memberTable(
    texts: PageTexts,
    who: Identity.Instructor,
    members: List<StaffMember>,
) = scrolling(texts.say("staff.title")) {
    table("students") {
        thead {
            tr {
                listOf("name", "role", "made", "used", "entry").forEach {
                    th(scope = ThScope.col) { +texts.say("staff.column.$it") }
                }
            }
        }
        tbody {
            members.forEach { one ->
                tr {
                    td {
                        val name = texts.nameOf(one)
                        +if (one.id == who.id) texts.say("staff.you", name) else name
                        naming(texts, one)
                    }
                    td { +texts.say("staff.role.${one.role.code}") }
                    td { moment(one.madeAt) }
                    td { one.lastUsedAt?.let { moment(it) } ?: +texts.say("staff.never") }
                    td { access(texts, one) }
                }
            }
        }
    }
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

private fun FlowContent.access(
    texts: PageTexts,
    one: StaffMember,
) {
    val name = texts.nameOf(one)
    one.revokedAt?.let { p { +texts.say("staff.revoked", it.forPeople()) } }
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
        button { +texts.say("staff.add.do") }
    }
}

private fun PageTexts.nameOf(one: StaffMember): String = one.name.ifEmpty { say("staff.unnamed") }
