package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import kotlinx.html.a
import kotlinx.html.p
import kotlinx.html.role
import rasterlab.grader.problem.ProblemPage

/** A failure as a page, for people: what happened, what to do, and where to go. The detail is for programs, in English. */
object ErrorPage : ProblemPage {
    override suspend fun show(
        call: ApplicationCall,
        status: HttpStatusCode,
        code: String,
        detail: String,
    ) {
        val texts = call.texts()
        call.respondPage(texts, who = null, texts.say("error.title"), status) {
            p("problem") {
                role = "alert"
                +texts.problem(code)
            }
            p("legend") { +texts.say("error.code", status.value.toString(), code) }
            p("ways") {
                call.pageBefore()?.let { a(it) { +texts.say("error.again") } }
                a("/") { +texts.say("error.back") }
            }
        }
    }
}
