package rasterlab.grader.api

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject

/**
 * Texts about the calls of the API, which say what their routes do not tell.
 *
 * @param operations by method and path, such as `GET /api/v1/courses`: summary, description, parameters outside of the
 * path, requestBody and responses as OpenAPI has them, and `problems`, the statuses of refusals that are its own
 * @param document all but the paths: headers, parameters and schemas
 */
internal class WrittenOperations(
    val operations: Map<String, JsonObject>,
    val document: JsonObject,
) {
    /** The text about a call. */
    fun of(name: String): JsonObject =
        checkNotNull(operations[name]) { "$name is served, and none of ${PARTS.map { "$it.json" }} says what it does" }

    companion object {
        /** Files with the operations and the schemas that belong to one part of the API. */
        private val PARTS =
            listOf("machines", "courses", "students", "exercises", "class", "submissions", "regrades", "points") +
                listOf("comments", "copies", "versions", "complaints", "exams", "platforms")

        fun read(): WrittenOperations {
            val parts = PARTS.associateWith(::file)
            val document = file("common")
            val components = document.getValue("components").jsonObject
            val schemas = once(parts.values.map { it["schemas"] } + components["schemas"])
            return WrittenOperations(
                once(parts.map { (part, file) -> tagged(file.getValue("operations").jsonObject, part) })
                    .mapValues { (_, operation) -> operation.jsonObject },
                JsonObject(document + ("components" to JsonObject(components + ("schemas" to JsonObject(schemas))))),
            )
        }

        private fun tagged(
            operations: JsonObject,
            part: String,
        ) = JsonObject(
            operations.mapValues { (_, one) ->
                JsonObject(one.jsonObject + ("tags" to JsonArray(listOf(JsonPrimitive(part)))))
            },
        )

        /** The entries of all the objects, none of which may stand in two. */
        private fun once(objects: List<JsonElement?>): Map<String, JsonElement> {
            val entries = objects.flatMap { it?.jsonObject.orEmpty().entries }
            val twice = entries.groupBy { it.key }.filterValues { it.size > 1 }.keys
            check(twice.isEmpty()) { "$twice stands in more than one file" }
            return entries.associate { it.toPair() }
        }

        private fun file(name: String): JsonObject {
            val place =
                checkNotNull(WrittenOperations::class.java.getResource("$name.json")) { "$name.json is missing" }
            return Json.parseToJsonElement(place.readText()).jsonObject
        }
    }
}
