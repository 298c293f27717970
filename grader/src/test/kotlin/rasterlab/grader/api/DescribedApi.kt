package rasterlab.grader.api

import io.ktor.client.request.get
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import rasterlab.grader.Visit
import rasterlab.grader.json

/** The description of the API that a server gives. */
class DescribedApi(
    val document: JsonObject,
) {
    val paths = document.getValue("paths").jsonObject

    /** The object that a reference names, or the object itself where it is none. */
    fun whole(told: JsonObject): JsonObject {
        val reference = told["\$ref"]?.jsonPrimitive?.content ?: return told
        val parts = reference.removePrefix("#/").split("/")
        return parts.fold(document) { place, part -> checkNotNull(place[part]?.jsonObject) { "$reference is nowhere" } }
    }

    /** The names of the parameters that a method of an address has; none where it has no such method. */
    fun parameters(
        path: String,
        method: String,
    ): List<String> =
        paths
            .getValue(path)
            .jsonObject[method]
            ?.jsonObject
            ?.get("parameters")
            ?.jsonArray
            .orEmpty()
            .map {
                whole(it.jsonObject)
                    .getValue("name")
                    .jsonPrimitive.content
            }
}

/** Asks for the description. */
suspend fun Visit.describedApi() = DescribedApi(client.get("/openapi.json").json())
