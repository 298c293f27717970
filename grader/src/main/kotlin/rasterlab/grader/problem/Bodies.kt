package rasterlab.grader.problem

import io.ktor.http.BadContentTypeFormatException
import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.request.contentType
import io.ktor.server.request.receiveChannel
import io.ktor.server.response.respondText
import io.ktor.utils.io.discard
import io.ktor.utils.io.readRemaining
import kotlinx.coroutines.withTimeoutOrNull
import kotlinx.io.readByteArray
import kotlinx.serialization.DeserializationStrategy
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json

private const val JSON_BYTES = 16 * 1024
private const val SLOWEST_SECONDS = 20L
private const val READ_AWAY_BYTES = 32L shl 20
private const val KEY_MOST = 200

/** The body, never keeping more than [limit] bytes of it. */
suspend fun ApplicationCall.receiveAtMost(limit: Int): ByteArray {
    val body =
        withTimeoutOrNull(SLOWEST_SECONDS * 1_000) {
            val channel = receiveChannel()
            val bytes = channel.readRemaining(limit + 1L).readByteArray()
            // A client that is still sending would miss the answer, so the rest is read and dropped.
            if (bytes.size > limit) channel.discard(READ_AWAY_BYTES)
            bytes
        } ?: throw Rejection.TooSlow(SLOWEST_SECONDS)
    if (body.size > limit) throw Rejection.TooLarge(limit)
    return body
}

suspend fun <T> ApplicationCall.receiveJson(format: DeserializationStrategy<T>): T {
    bodyType(ContentType.Application.Json)
    val text = receiveAtMost(JSON_BYTES).decodeToString()
    try {
        return Json.decodeFromString(format, text)
    } catch (failure: SerializationException) {
        throw Rejection.Malformed(
            "the body is not the JSON expected here: ${failure.message.orEmpty().lineSequence().first()}",
        )
    }
}

/** The one of [expected] that the sender says the body is. */
fun ApplicationCall.bodyType(vararg expected: ContentType): ContentType {
    val found =
        try {
            request.contentType()
        } catch (malformed: BadContentTypeFormatException) {
            null
        }
    return expected.firstOrNull { found != null && found.match(it) }
        ?: throw Rejection.WrongMediaType(
            request.headers[HttpHeaders.ContentType].orEmpty(),
            expected.joinToString(" or "),
        )
}

/** Answers in JSON, which is all that the API speaks: `Accept` is not asked after something was done. */
suspend inline fun <reified T> ApplicationCall.respondJson(
    value: T,
    status: HttpStatusCode = HttpStatusCode.OK,
) = respondText(Json.encodeToString(value), ContentType.Application.Json, status)

/** The key under which the sender may repeat this request, or null. */
fun ApplicationCall.idempotencyKey(least: Int = 1): String? {
    val key = request.headers["Idempotency-Key"] ?: return null
    if (key.length !in least..KEY_MOST || key.any { it !in '!'..'~' }) throw Rejection.BadKey(least, KEY_MOST)
    return key
}
