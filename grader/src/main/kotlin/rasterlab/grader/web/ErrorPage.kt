package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import kotlinx.html.a
import kotlinx.html.body
import kotlinx.html.h1
import kotlinx.html.head
import kotlinx.html.html
import kotlinx.html.lang
import kotlinx.html.meta
import kotlinx.html.p
import kotlinx.html.role
import kotlinx.html.stream.createHTML
import kotlinx.html.title
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

/** A failure as a page, for people: what happened, what to do, and where to go. The detail is for programs, in English. */
object ErrorPage : ProblemPage {
    override suspend fun show(
        call: ApplicationCall,
        status: HttpStatusCode,
        code: String,
        detail: String,
        added: (String) -> String?,
    ) {
        val texts = call.texts()
        call.respondPage(texts, who = null, texts.say("error.title"), status) {
            p("problem") {
                role = "alert"
                +texts.problem(code)
            }
            added(texts.language)?.let { p { +it } }
            p("legend") { +texts.say("error.code", status.value.toString(), code) }
            p("ways") {
                call.pageBefore()?.let { a(it) { +texts.say("error.again") } }
                a("/") { +texts.say("error.back") }
            }
        }
    }
}
