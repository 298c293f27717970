package rasterlab.grader.edge

import io.ktor.http.HttpStatusCode
import kotlinx.serialization.json.Json
import rasterlab.grader.problem.Problem

/** An answer that the door gives itself, as bytes made before anybody asks; it ends the connection. */
internal class Refusal(
    status: HttpStatusCode,
    code: String,
    detail: String,
    vararg headers: String,
) {
    val answer: ByteArray

    init {
        val problem = Problem("urn:rasterlab:problem:$code", status.description, status.value, detail)
        val body = Json.encodeToString(problem).toByteArray()
        val head =
            listOf(
                "HTTP/1.1 ${status.value} ${status.description}",
                "Content-Type: application/problem+json",
                "Content-Length: ${body.size}",
                "Connection: close",
                *headers,
            )
        answer = head.joinToString("\r\n", postfix = "\r\n\r\n").toByteArray() + body
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

internal val NO_ENGINE =
    Refusal(
        HttpStatusCode.ServiceUnavailable,
        "no-connection",
        "the server cannot take one more request just now; nothing was stored, try again later",
        "Retry-After: 5",
    )
