package rasterlab.grader.problem

import io.ktor.http.BadContentTypeFormatException
import io.ktor.http.ContentType
import io.ktor.http.HttpHeaders
import io.ktor.server.application.Application
import io.ktor.server.application.ApplicationCall
import io.ktor.server.application.ApplicationCallPipeline
import io.ktor.server.application.call
import io.ktor.server.request.contentType
import io.ktor.server.request.receiveChannel
import io.ktor.util.AttributeKey
import io.ktor.util.pipeline.PipelinePhase
import io.ktor.utils.io.cancel
import io.ktor.utils.io.discard
import io.ktor.utils.io.readRemaining
import kotlinx.coroutines.withTimeoutOrNull
import kotlinx.io.readByteArray
import java.nio.ByteBuffer
import java.nio.CharBuffer
import kotlin.time.Duration

private const val READ_AWAY_BYTES = 32L shl 20
private const val SECRET_KEY_LEAST = 16
private const val KEY_MOST = 200
private val PATIENCE = AttributeKey<Duration>("how long a body may take")

/**
 * Bounds how long a body is waited for. One that still comes when its answer is out is read and
 * dropped for as long again, since a client that is sending would miss the answer; then, and after
 * an answer that says `Connection: close`, nothing more is read, and the next byte ends the connection.
 * To be called before the plugin that answers failures, so that this comes after its answers.
 */
fun Application.waitForBodies(patience: Duration) {
    attributes.put(PATIENCE, patience)
    val aroundAll = PipelinePhase("AroundAll")
    insertPhaseBefore(ApplicationCallPipeline.Setup, aroundAll)
    intercept(aroundAll) {
        proceed()
        val rest = call.request.receiveChannel()
        if (call.response.headers[HttpHeaders.Connection] != "close") {
            withTimeoutOrNull(patience) { rest.discard(READ_AWAY_BYTES) }
        }
        rest.cancel()
    }
}

/** Applies [read] to the body, if all of it comes in time. */
suspend fun <T : Any> ApplicationCall.inTime(read: suspend () -> T): T {
    val patience = application.attributes[PATIENCE]
    return withTimeoutOrNull(patience) { read() } ?: throw Rejection.TooSlow(patience.inWholeSeconds)
}

/** The body, never keeping more than [limit] bytes of it; one that is longer is [tooLarge]. */
suspend fun ApplicationCall.receiveAtMost(
    limit: Int,
    tooLarge: () -> Rejection = { Rejection.TooLarge(limit) },
): ByteArray {
    val body = inTime { receiveChannel().readRemaining(limit + 1L).readByteArray() }
    if (body.size > limit) throw tooLarge()
    return body
}

/** The text of [bytes], or the rejection made of where they are not UTF-8. */
fun utf8(
    bytes: ByteArray,
    rejection: (String) -> Rejection,
): String {
    val left = ByteBuffer.wrap(bytes)
    val text = CharBuffer.allocate(bytes.size)
    if (Charsets.UTF_8
            .newDecoder()
            .decode(left, text, true)
            .isError
    ) {
        throw rejection("byte ${left.position() + 1} of ${bytes.size} is 0x%02X".format(left.get()))
    }
    return text.flip().toString()
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

/**
 * The key under which the sender may repeat this request, or null.
 *
 * @param secret whether the key alone gets the answer again, so that it must be hard to guess
 */
fun ApplicationCall.idempotencyKey(secret: Boolean = false): String? {
    val key = request.headers["Idempotency-Key"] ?: return null
    val least = if (secret) SECRET_KEY_LEAST else 1
    if (key.length !in least..KEY_MOST || key.any { it !in '!'..'~' }) {
        throw Rejection.BadKey(key.length, least..KEY_MOST, secret)
    }
    return key
}

/** Whether a switch of the address is on. */
fun ApplicationCall.flag(name: String): Boolean =
    when (val told = request.queryParameters[name]) {
        null, "false" -> false
        "true" -> true
        else -> throw Rejection.Malformed("$name is '$told', allowed are true, false")
    }
