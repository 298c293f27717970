package rasterlab.grader.problem

import com.fasterxml.jackson.databind.JsonNode
import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondText
import kotlinx.serialization.json.Json
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.json.JsonFields

private const val JSON_BYTES = 16 * 1024

/** The most characters of a wrong value that are repeated. */
private const val SHOWN = 80

/** Applies [read] to the object that the body is, in which only the [known] fields may occur. */
suspend fun <T> ApplicationCall.receiveJson(
    vararg known: String,
    read: (JsonFields) -> T,
): T {
    bodyType(ContentType.Application.Json)
    val text = utf8(receiveAtMost(JSON_BYTES)) { Rejection.Malformed("the body is not UTF-8 text: $it") }
    try {
        return read(JsonFields.parse("the body", text, *known))
    } catch (failure: CatalogueException) {
        throw Rejection.Malformed(failure.message.orEmpty())
    }
}

/**
 * Reads a value as somebody would type it into a field of a form: a text as it is, a number in its digits, and null as
 * nothing.
 *
 * @param field its name, for the message
 * @throws Rejection.Malformed where it is an object or a list
 */
fun typed(
    field: String,
    value: JsonNode,
): String =
    when {
        value.isNull -> ""
        value.isValueNode -> value.asText()
        else -> throw Rejection.Malformed("$field is ${"$value".take(SHOWN)}, expected a text, a number or null")
    }

/** Answers in JSON, which is all that the API speaks: `Accept` is not asked after something was done. */
suspend inline fun <reified T> ApplicationCall.respondJson(
    value: T,
    status: HttpStatusCode = HttpStatusCode.OK,
) = respondText(Json.encodeToString(value), ContentType.Application.Json, status)
