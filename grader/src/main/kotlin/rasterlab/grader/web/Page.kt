package rasterlab.grader.web

import io.ktor.http.HttpHeaders
import io.ktor.http.HttpMethod
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.html.respondHtml
import io.ktor.server.request.httpMethod
import io.ktor.server.request.path
import io.ktor.server.response.header
import kotlinx.html.ButtonType
import kotlinx.html.CommonAttributeGroupFacade
import kotlinx.html.DIV
import kotlinx.html.FlowContent
import kotlinx.html.InputType
import kotlinx.html.MAIN
import kotlinx.html.TD
import kotlinx.html.ThScope
import kotlinx.html.a
import kotlinx.html.body
import kotlinx.html.button
import kotlinx.html.div
import kotlinx.html.footer
import kotlinx.html.form
import kotlinx.html.h1
import kotlinx.html.head
import kotlinx.html.header
import kotlinx.html.html
import kotlinx.html.id
import kotlinx.html.input
import kotlinx.html.label
import kotlinx.html.lang
import kotlinx.html.link
import kotlinx.html.main
import kotlinx.html.meta
import kotlinx.html.nav
import kotlinx.html.p
import kotlinx.html.script
import kotlinx.html.span
import kotlinx.html.table
import kotlinx.html.tbody
import kotlinx.html.td
import kotlinx.html.th
import kotlinx.html.thead
import kotlinx.html.title
import kotlinx.html.tr
import rasterlab.grader.course.Identity
import rasterlab.grader.course.StaffRole
import rasterlab.grader.problem.LANGUAGES
import rasterlab.grader.submission.HandedForm

/**
 * Answers with a page: heading, navigation for this role, and [content].
 *
 * @param form that another language begins with as it is filled in, by its id; null where none is to be kept
 */
suspend fun ApplicationCall.respondPage(
    texts: PageTexts,
    who: Identity?,
    heading: String,
    status: HttpStatusCode = HttpStatusCode.OK,
    form: String? = null,
    content: MAIN.() -> Unit,
) {
    // A form's address shows nothing by itself, so another language begins where the form was.
    val here = request.httpMethod == HttpMethod.Get || form != null
    val path = if (here) request.path().here() else pageBefore() ?: "/"
    val viewed = attributes.getOrNull(VIEWED)
    response.header(HttpHeaders.CacheControl, "no-store")
    respondHtml(status) {
        lang = texts.language
        head {
            meta(charset = "utf-8")
            meta(name = "viewport", content = "width=device-width, initial-scale=1")
            meta(name = "color-scheme", content = "light dark")
            title("$heading — ${texts.say("app")}")
            link(rel = "icon", href = "/assets/icon.svg", type = "image/svg+xml")
            link(rel = "stylesheet", href = "/assets/rasterlab.css")
            script(src = "/assets/follow.js") { defer = true }
        }
        body {
            a("#content", classes = "skip") { +texts.say("skip") }
            header { navigation(texts, who, path, form) }
            viewed?.let { viewing(texts, it) }
            main {
                id = "content"
                h1 { +heading }
                content()
            }
            footer { p { +texts.say("app.about") } }
        }
    }
}

/** Tells staff that they have a student's view, and leads out of it. */
private fun FlowContent.viewing(
    texts: PageTexts,
    student: Identity.StudentIdentity,
) = div("viewing") {
    attributes["role"] = "status"
    span { +texts.say("view.banner", student.name) }
    form("/instructor/view/end", method = kotlinx.html.FormMethod.post) { button { +texts.say("view.end") } }
}

private fun FlowContent.navigation(
    texts: PageTexts,
    who: Identity?,
    path: String,
    form: String?,
) = nav {
    a("/", classes = "brand") { +texts.say("app") }
    if (who != null) a("/exercises") { +texts.say("nav.exercises") }
    if (who is Identity.StaffIdentity) a("/instructor") { +texts.say("nav.${StaffRole.of(who).code}") }
    span("spread") {}
    if (who != null && who.name.isNotEmpty()) span("who") { +who.name }
    LANGUAGES.filter { it != texts.language }.forEach { other ->
        val label = "${texts.say("nav.language")}: $other"
        if (form == null) {
            a("$path?lang=$other") {
                attributes["hreflang"] = other
                attributes["aria-label"] = label
                +other.uppercase()
            }
        } else {
            button(classes = "plain", type = ButtonType.submit) {
                name = HandedForm.AGAIN
                value = "true"
                formAction = "$path?lang=$other"
                attributes["formnovalidate"] = "formnovalidate"
                attributes["form"] = form
                attributes["aria-label"] = label
                +other.uppercase()
            }
        }
    }
    if (who != null) {
        form("/sign-out", method = kotlinx.html.FormMethod.post) { button(classes = "plain") { +texts.say("nav.out") } }
    }
}

/** A labelled text field that must be filled in. */
fun FlowContent.field(
    label: String,
    field: String,
    type: InputType = InputType.text,
    filling: String = "off",
) = label {
    span { +label }
    input(type, name = field) {
        required = true
        attributes["autocomplete"] = filling
    }
}

/** A part that is scrolled sideways where the window is narrow, by keys too; readers that speak call it [name]. */
internal fun FlowContent.scrolling(
    name: String,
    inner: DIV.() -> Unit,
) = div("scroll") {
    scrolledByKeys(name)
    inner()
}

/** Lets keys scroll the element, which may be wider or higher than its place; readers that speak call it [name]. */
internal fun CommonAttributeGroupFacade.scrolledByKeys(name: String) {
    attributes["tabindex"] = "0"
    attributes["role"] = "group"
    attributes["aria-label"] = name
}

/**
 * A table with a row for each of [all], which is scrolled where it is wider than the page; on a phone each row stands
 * as a list, in which every cell tells its column.
 *
 * @param name for readers that speak
 * @param columns their names, and what a cell shows
 * @param numbers the names of those that show numbers
 */
internal fun <T> FlowContent.stacked(
    name: String,
    columns: List<Pair<String, FlowContent.(T) -> Unit>>,
    all: List<T>,
    numbers: Set<String> = emptySet(),
) = scrolling(name) {
    fun kind(column: String) = if (column in numbers) "number" else null
    table("students stacked") {
        thead { tr { columns.forEach { (column) -> th(scope = ThScope.col, classes = kind(column)) { +column } } } }
        tbody {
            all.forEach { one ->
                tr {
                    columns.forEach { (column, content) ->
                        td(kind(column)) {
                            column(column)
                            div { content(one) }
                        }
                    }
                }
            }
        }
    }
}

/** Names the column for a phone, which shows no row of headings. */
internal fun TD.column(name: String) {
    attributes["data-column"] = name
}
