package rasterlab.grader.edge

import io.ktor.http.HttpStatusCode
import kotlinx.serialization.json.Json
import rasterlab.grader.problem.LANGUAGES
import rasterlab.grader.problem.ProblemDocument
import rasterlab.grader.web.PageTexts
import rasterlab.grader.web.plainErrorPage

/** An answer that the door gives itself, as bytes made before anybody asks; it ends the connection. */
internal class Refusal(
    private val status: HttpStatusCode,
    code: String,
    detail: String,
    private vararg val headers: String,
) {
    private val problem =
        answer(
            "application/problem+json",
            Json.encodeToString(
                ProblemDocument("urn:rasterlab:problem:$code", status.description, status.value, detail),
            ),
        )
    private val pages =
        LANGUAGES.associateWith { answer("text/html; charset=utf-8", plainErrorPage(PageTexts.of(it), status, code)) }

    /** A page for people, a problem document for programs. */
    fun answer(asker: Requester): ByteArray = if (asker.person) pages.getValue(asker.language) else problem

    private fun answer(
        type: String,
        body: String,
    ): ByteArray {
        val bytes = body.toByteArray()
        val head =
            listOf(
                "HTTP/1.1 ${status.value} ${status.description}",
                "Content-Type: $type",
                "Content-Length: ${bytes.size}",
                "Cache-Control: no-store",
                "Connection: close",
                *headers,
            )
        return head.joinToString("\r\n", postfix = "\r\n\r\n").toByteArray() + bytes
    }
}

internal fun malformed(detail: String) = Refusal(HttpStatusCode.BadRequest, "malformed-request", detail)

internal val TOO_MANY =
    Refusal(
        HttpStatusCode.ServiceUnavailable,
        "too-many-connections",
        "too many connections are open, from this address or in all; close some or try again later",
        "Retry-After: 5",
    )

internal val CLEAR_TEXT =
    Refusal(
        HttpStatusCode.BadRequest,
        "clear-text",
        "this port speaks HTTPS only: the address must begin with https://",
    )

internal val NO_ENGINE =
    Refusal(
        HttpStatusCode.ServiceUnavailable,
        "no-connection",
        "the server cannot take one more request just now; nothing was stored, try again later",
        "Retry-After: 5",
    )
