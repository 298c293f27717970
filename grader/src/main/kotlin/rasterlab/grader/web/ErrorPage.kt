package rasterlab.grader.web

import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import kotlinx.html.a
import kotlinx.html.p
import rasterlab.grader.problem.ProblemPage

/** A failure as a page, for people. */
object ErrorPage : ProblemPage {
    override suspend fun show(
        call: ApplicationCall,
        status: HttpStatusCode,
        code: String,
        detail: String,
    ) {
        val texts = call.texts()
        call.respondPage(texts, who = null, texts.say("error.title"), status) {
            p { +texts.problem(code, detail) }
            p { a("/") { +texts.say("error.back") } }
        }
    }
}
