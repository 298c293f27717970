package rasterlab.grader.problem

import io.ktor.http.ContentType
import io.ktor.http.HttpStatusCode
import io.ktor.server.application.ApplicationCall
import io.ktor.server.response.respondText
import kotlinx.serialization.json.Json
import rasterlab.exercises.CatalogueException
import rasterlab.exercises.json.JsonFields

private const val JSON_BYTES = 16 * 1024

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

/** Answers in JSON, which is all that the API speaks: `Accept` is not asked after something was done. */
suspend inline fun <reified T> ApplicationCall.respondJson(
    value: T,
    status: HttpStatusCode = HttpStatusCode.OK,
) = respondText(Json.encodeToString(value), ContentType.Application.Json, status)
