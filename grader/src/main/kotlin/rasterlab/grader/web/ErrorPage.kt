package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.util.AttributeKey
import kotlinx.html.FlowContent
import kotlinx.html.a
import kotlinx.html.body
import kotlinx.html.div
import kotlinx.html.h1
import kotlinx.html.head
import kotlinx.html.html
import kotlinx.html.lang
import kotlinx.html.li
import kotlinx.html.meta
import kotlinx.html.p
import kotlinx.html.role
import kotlinx.html.stream.createHTML
import kotlinx.html.title
import kotlinx.html.ul
import rasterlab.grader.problem.ProblemPage

/** The page of a failure that is met before any page can be asked for: by itself, without styles and scripts. */
fun plainErrorPage(
    texts: PageTexts,
    status: HttpStatusCode,
    code: String,
): String =
    "<!DOCTYPE html>\n" +
        createHTML(prettyPrint = false).html {
            lang = texts.language
            head {
                meta(charset = "utf-8")
                meta(name = "viewport", content = "width=device-width, initial-scale=1")
                meta(name = "color-scheme", content = "light dark")
                title("${texts.say("error.title")} — ${texts.say("app")}")
            }
            body {
                h1 { +texts.say("error.title") }
                p {
                    role = "alert"
                    +texts.problem(code)
                }
                p { +texts.say("error.code", status.value.toString(), code) }
                p { a("/") { +texts.say("error.back") } }
            }
        }

/** Shows a form that was refused again, with all that it held, so that nobody types it twice. */
fun interface FormAgain {
    /** @param added what there is more to say, one thing each, by language */
    suspend fun show(
        status: HttpStatusCode,
        code: String,
        added: (String) -> List<String>,
    )
}

/** Stands at a call that has read a form which can be shown again. */
val FORM_AGAIN = AttributeKey<FormAgain>("the form that is shown again where it is refused")

/**
 * A failure as a page, for people: what happened, what to do, and where to go; where a form was read that can be
 * shown again, the page of the form. The detail is for programs, in English.
 */
object ErrorPage : ProblemPage {
    override suspend fun show(
        call: ApplicationCall,
        status: HttpStatusCode,
        code: String,
        detail: String,
        added: (String) -> List<String>,
    ) {
        val form = call.attributes.getOrNull(FORM_AGAIN).takeIf { code !in OUR_FAULT }
        if (form != null) return form.show(status, code, added)
        val texts = call.texts()
        call.respondPage(texts, who = null, texts.say("error.title"), status) {
            problem(texts, status, code, added(texts.language))
            p("ways") {
                call.pageBefore()?.let { a(it) { +texts.say("error.again") } }
                a("/") { +texts.say("error.back") }
            }
        }
    }

    /** The problems with which no page can be made that asks the storage. */
    private val OUR_FAULT = setOf("storage", "internal")
}

/** Tells people, and whoever they ask, what happened and what to do. */
fun FlowContent.problem(
    texts: PageTexts,
    status: HttpStatusCode,
    code: String,
    details: List<String>,
) {
    div("problem") {
        role = "alert"
        p { +texts.problem(code) }
        if (details.isNotEmpty()) ul { details.forEach { li { +it } } }
    }
    p("legend") { +texts.say("error.code", status.value.toString(), code) }
}
