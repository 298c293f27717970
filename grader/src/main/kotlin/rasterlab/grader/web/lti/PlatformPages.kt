package rasterlab.grader.web.lti

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
import kotlinx.html.code
import kotlinx.html.dd
import kotlinx.html.div
import kotlinx.html.dl
import kotlinx.html.dt
import kotlinx.html.form
import kotlinx.html.h2
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.p
import kotlinx.html.section
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.tr
import rasterlab.grader.course.Accounts
import rasterlab.grader.course.Identity
import rasterlab.grader.lti.Lti
import rasterlab.grader.lti.Platform
import rasterlab.grader.lti.PlatformForm
import rasterlab.grader.lti.PublishedKey
import rasterlab.grader.web.FORM_AGAIN
import rasterlab.grader.web.FormAgain
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.Refused
import rasterlab.grader.web.instructorHere
import rasterlab.grader.web.moment
import rasterlab.grader.web.problem
import rasterlab.grader.web.receiveForm
import rasterlab.grader.web.requireOwnForm
import rasterlab.grader.web.respondPage
import rasterlab.grader.web.scrolling
import rasterlab.grader.web.texts

private const val ADDRESS = "/instructor/lti"

/** The fields of a registration, in the order of Moodle's form where it has them, and whether each is an address. */
private val FIELDS =
    listOf(
        "name" to InputType.text,
        "issuer" to InputType.text,
        "client-id" to InputType.text,
        "deployment" to InputType.text,
        "keys-url" to InputType.url,
        "token-url" to InputType.url,
        "login-url" to InputType.url,
    )

/** Shows an instructor which platforms are trusted and what these are to be told, and lets them add and remove one. */
fun Route.platformPages(
    accounts: Accounts,
    lti: Lti,
) {
    get(ADDRESS) { call.respondPlatforms(call.instructorHere(accounts), lti, typed = null, refused = null) }
    post(ADDRESS) {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        val form = call.receiveForm()
        val again =
            FormAgain { status, code, added ->
                call.respondPlatforms(who, lti, form, Refused(status, code, added(call.texts().language)))
            }
        call.attributes.put(FORM_AGAIN, again)
        lti.platforms.add(form.platform(), who.id, key = null)
        call.respondRedirect(ADDRESS)
    }
    post("$ADDRESS/key") {
        call.requireOwnForm()
        lti.key.renew(call.instructorHere(accounts).id, key = null)
        call.respondRedirect(ADDRESS)
    }
    post("$ADDRESS/{platform}/remove") {
        call.requireOwnForm()
        val who = call.instructorHere(accounts)
        lti.platforms.remove(call.parameters.getOrFail("platform"), who.id)
        call.respondRedirect(ADDRESS)
    }
}

private fun Parameters.platform() =
    FIELDS.map { (field, _) -> get(field).orEmpty() }.let { (name, issuer, client, deployment, keys) ->
        val token = get("token-url").orEmpty()
        val login = get("login-url").orEmpty()
        PlatformForm(name, issuer, client, deployment, login, token, keys, get("staff") == "yes")
    }

private suspend fun ApplicationCall.respondPlatforms(
    who: Identity.Instructor,
    lti: Lti,
    typed: Parameters?,
    refused: Refused?,
) {
    val texts = texts()
    val places = places(lti)
    respondPage(texts, who, texts.say("lti.title"), refused?.status ?: HttpStatusCode.OK) {
        refused?.let { problem(texts, it.status, it.code, it.details) }
        p { a("/instructor") { +texts.say("token.back") } }
        p("plan") { +texts.say("lti.about", texts.zoneName) }
        val all = lti.platforms.all()
        if (all.isEmpty()) p { +texts.say("lti.none") } else platformTable(texts, all)
        section("card apart") { told(texts, places) }
        section("card apart") { addition(texts, typed) }
        section("card apart") { keys(texts, lti.key.published()) }
    }
}

private fun FlowContent.told(
    texts: PageTexts,
    places: ToolPlaces,
) {
    h2 { +texts.say("lti.told") }
    p { +texts.say("lti.told.about") }
    dl("told") {
        listOf(
            "tool" to places.launch,
            "login" to places.login,
            "back" to places.launch,
            "keys" to places.keys,
            "links" to places.launch,
            "configuration" to places.configuration,
        ).forEach { (name, place) ->
            dt { +texts.say("lti.told.$name") }
            dd { code { +"$place" } }
        }
    }
}

private fun FlowContent.keys(
    texts: PageTexts,
    published: List<PublishedKey>,
) {
    h2 { +texts.say("lti.keys") }
    p { +texts.say("lti.keys.about") }
    dl("told") {
        published.forEach { one ->
            val until = one.until
            dt { +if (until == null) texts.say("lti.keys.now") else texts.say("lti.keys.until", texts.time(until)) }
            dd { code { +one.id } }
        }
    }
    form("$ADDRESS/key", method = FormMethod.post) { button { +texts.say("lti.keys.do") } }
}

private fun FlowContent.platformTable(
    texts: PageTexts,
    all: List<Platform>,
) = scrolling(texts.say("lti.title")) {
    table("students") {
        thead {
            tr {
                listOf("name", "issuer", "client-id", "deployment", "staff", "added", "change").forEach {
                    th(scope = ThScope.col) { +texts.say("lti.column.$it", texts.zoneName) }
                }
            }
        }
        tbody {
            all.forEach { one ->
                tr {
                    td { +one.name }
                    td { +one.issuer }
                    td { +one.clientId }
                    td { +one.deployment }
                    td { +texts.say(if (one.makesStaff) "lti.staff.made" else "lti.staff.asked") }
                    td { moment(texts, one.addedAt) }
                    td { removal(texts, one) }
                }
            }
        }
    }
}

private fun FlowContent.removal(
    texts: PageTexts,
    one: Platform,
) = div("ways") {
    form("$ADDRESS/${one.id}/remove", method = FormMethod.post) {
        button(classes = "plain") {
            attributes["aria-label"] = "${texts.say("lti.remove")}: ${one.name}"
            +texts.say("lti.remove")
        }
    }
}

private fun FlowContent.addition(
    texts: PageTexts,
    typed: Parameters?,
) {
    h2 { +texts.say("lti.add") }
    p { +texts.say("lti.add.about") }
    form(ADDRESS, method = FormMethod.post) {
        FIELDS.forEach { (field, kind) ->
            label {
                span { +texts.say("lti.field.$field") }
                input(kind, name = field) {
                    value = typed?.get(field).orEmpty()
                    required = true
                    attributes["autocomplete"] = "off"
                }
            }
        }
        label("consent") {
            input(InputType.checkBox, name = "staff") {
                value = "yes"
                checked = typed?.get("staff") == "yes"
            }
            span { +texts.say("lti.field.staff") }
        }
        button { +texts.say("lti.add.do") }
    }
}
