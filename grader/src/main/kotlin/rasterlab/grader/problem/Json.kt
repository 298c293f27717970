package rasterlab.grader.problem

import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.core.StreamReadFeature
import com.fasterxml.jackson.databind.json.JsonMapper
import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondText
import kotlinx.serialization.DeserializationStrategy
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json

private const val JSON_BYTES = 16 * 1024

/** kotlinx.serialization takes the last of two fields with one name, so Jackson looks too. */
private val strict = JsonMapper.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build()

suspend fun <T> ApplicationCall.receiveJson(format: DeserializationStrategy<T>): T {
    bodyType(ContentType.Application.Json)
    val text = utf8(receiveAtMost(JSON_BYTES)) { Rejection.Malformed("the body is not UTF-8 text: $it") }
    try {
        return Json.decodeFromString(format, text).also { strict.readTree(text) }
    } catch (failure: SerializationException) {
        throw notExpected(failure.message.orEmpty())
    } catch (failure: JsonProcessingException) {
        throw notExpected(
            "${failure.originalMessage} in line ${failure.location.lineNr}, column ${failure.location.columnNr}",
        )
    }
}

/** Answers in JSON, which is all that the API speaks: `Accept` is not asked after something was done. */
suspend inline fun <reified T> ApplicationCall.respondJson(
    value: T,
    status: HttpStatusCode = HttpStatusCode.OK,
) = respondText(Json.encodeToString(value), ContentType.Application.Json, status)

private fun notExpected(reason: String) =
    Rejection.Malformed("the body is not the JSON expected here: ${reason.lineSequence().first()}")
