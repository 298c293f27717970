package rasterlab.grader.problem

import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode
import io.ktor.http.HttpStatusCode.Companion.InternalServerError
import io.ktor.http.HttpStatusCode.Companion.ServiceUnavailable
import io.ktor.http.URLDecodeException
import io.ktor.http.content.TextContent
import io.ktor.server.application.ApplicationCall
import io.ktor.server.http.content.HttpStatusCodeContent
import io.ktor.server.plugins.BadRequestException
import io.ktor.server.plugins.statuspages.StatusPagesConfig
import io.ktor.server.request.httpMethod
import io.ktor.server.request.path
import io.ktor.server.response.header
import io.ktor.server.response.respond
import io.ktor.util.cio.ChannelIOException
import io.ktor.utils.io.ClosedByteChannelException
import kotlinx.coroutines.CancellationException
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json
import org.jdbi.v3.core.JdbiException
import org.slf4j.Logger
import org.slf4j.LoggerFactory
import rasterlab.grader.limits.tell
import java.sql.SQLException

/** The seconds after which a storage that does not answer is worth asking again, as a header says them. */
private const val STORAGE_SECONDS = "5"

/** An error as RFC 9457 lays it out. */
@Serializable
data class ProblemDocument(
    val type: String,
    val title: String,
    val status: Int,
    val detail: String,
)

/** How a failure is shown: as a problem document to programs, as a page to people. */
fun interface ProblemPage {
    /**
     * @param detail in English, for programs
     * @param added what there is more to say to people, one thing each, by language
     */
    suspend fun show(
        call: ApplicationCall,
        status: HttpStatusCode,
        code: String,
        detail: String,
        added: (String) -> List<String>,
    )
}

/**
 * Turns every failure into an answer without a stack trace.
 *
 * @param page for paths outside the API
 */
fun StatusPagesConfig.showProblems(page: ProblemPage) {
    val log = LoggerFactory.getLogger("rasterlab.grader.problem")

    suspend fun show(
        call: ApplicationCall,
        status: HttpStatusCode,
        code: String,
        detail: String,
        added: (String) -> List<String> = { emptyList() },
    ) = if (call.isForPrograms()) {
        call.respondProblem(status, code, detail)
    } else {
        page.show(call, status, code, detail, added)
    }
    exception<Rejection> { call, rejection ->
        rejection.allowance?.let { call.tell(it) }
        rejection.retryAfter()?.let { call.response.header(HttpHeaders.RetryAfter, it.toString()) }
        when (rejection) {
            is Rejection.NotSignedIn -> call.response.header(HttpHeaders.WWWAuthenticate, "Bearer realm=\"rasterlab\"")
            is Rejection.WrongMethod -> call.response.header(HttpHeaders.Allow, rejection.allowed.joinToString())
            is Rejection.TooSlow -> call.response.header(HttpHeaders.Connection, "close")
            else -> Unit
        }
        val code = if (call.isForPrograms()) rejection.code else rejection.pageText
        show(call, rejection.status(), code, rejection.message, rejection::details)
    }
    exception<BadRequestException> { call, malformed ->
        log.debug("{} {}: {}", call.request.httpMethod.value, call.request.path(), malformed.message)
        show(call, HttpStatusCode.BadRequest, "malformed-request", "the request cannot be read")
    }
    // The client has gone: a page was closed, a download was broken off.
    exception<ChannelIOException> { call, gone -> log.gone(call, gone) }
    exception<ClosedByteChannelException> { call, gone -> log.gone(call, gone) }
    // The server is stopping, and pages that are still open need not be told.
    exception<CancellationException> { _, stopping -> throw stopping }
    exception<URLDecodeException> { call, malformed ->
        show(call, HttpStatusCode.BadRequest, "malformed-request", "the address or the form: ${malformed.message}")
    }
    exception<Throwable> { call, failure ->
        log.error("{} {} failed", call.request.httpMethod.value, call.request.path(), failure)
        if (failure is JdbiException || failure is SQLException) {
            call.response.header(HttpHeaders.RetryAfter, STORAGE_SECONDS)
            show(
                call,
                ServiceUnavailable,
                "storage",
                "the storage does not answer; nothing was stored, try again later",
            )
        } else {
            show(call, InternalServerError, "internal", "the server made a mistake; it is in its log")
        }
    }
    for (status in HttpStatusCode.allStatusCodes.filter { it.value >= HttpStatusCode.BadRequest.value }) {
        status(status) { found ->
            // A page that says itself what is wrong stays as it is.
            if (content is HttpStatusCodeContent) show(call, found, found.code(), call.plainDetail(found))
        }
    }
}

private fun Logger.gone(
    call: ApplicationCall,
    how: Exception,
) = debug("{} {}: {}", call.request.httpMethod.value, call.request.path(), how.message)

suspend fun ApplicationCall.respondProblem(
    status: HttpStatusCode,
    code: String,
    detail: String,
) {
    val problem = ProblemDocument("urn:rasterlab:problem:$code", status.description, status.value, detail)
    respond(TextContent(Json.encodeToString(problem), ContentType.Application.ProblemJson, status))
}

private fun HttpStatusCode.code() = description.lowercase().replace(' ', '-')

private fun ApplicationCall.isForPrograms() = isForPrograms(request.path())

/** Whether programs call there, which no page would serve. */
fun isForPrograms(path: String) =
    path.startsWith("/api/") || path in setOf("/openapi.json", "/healthz", "/readyz", "/metrics")

private fun ApplicationCall.plainDetail(status: HttpStatusCode) =
    when (status) {
        HttpStatusCode.NotFound -> "nothing is at ${request.path()}"
        HttpStatusCode.TooManyRequests -> "too many requests from this address; see Retry-After"
        else -> status.description
    }
