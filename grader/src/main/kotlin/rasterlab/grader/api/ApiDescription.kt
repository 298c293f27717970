// The description of the API for programs: it is made of the routes and of what is written about them.
package rasterlab.grader.api

import io.ktor.http.ContentType
import io.ktor.server.auth.AuthenticationRouteSelector
import io.ktor.server.plugins.ratelimit.RateLimitRouteSelector
import io.ktor.server.response.respondText
import io.ktor.server.routing.HttpMethodRouteSelector
import io.ktor.server.routing.OpenApiRoutePathFormat
import io.ktor.server.routing.Route
import io.ktor.server.routing.RoutingNode
import io.ktor.server.routing.application
import io.ktor.server.routing.get
import io.ktor.server.routing.getAllRoutes
import io.ktor.server.routing.path
import io.ktor.server.routing.routingRoot
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import rasterlab.engine.ProductVersion

/** Serves the description of the API, which is made when somebody asks for it first. */
fun Route.apiDescription() {
    val description by lazy { describe(application.routingRoot).toString() }
    get(ADDRESS) { call.respondText(description, ContentType.Application.Json) }
}

/**
 * Describes in OpenAPI 3.1 the routes for programs: their methods, addresses and parameters, who must sign in, and what
 * is refused for these reasons. The sentences and the shapes of bodies, which no route can tell, are written in files
 * beside this class.
 *
 * @throws IllegalStateException where a route is written about nowhere, or a route is that there is not
 */
internal fun describe(
    root: RoutingNode,
    written: WrittenOperations = WrittenOperations.read(),
): JsonObject {
    val calls = root.getAllRoutes().mapNotNull(ServedCall::of).sortedBy { it.path }
    val unserved = written.operations.keys - calls.map { it.name }.toSet()
    check(unserved.isEmpty()) { "no route serves $unserved, which is written about" }
    val paths =
        calls.groupBy { it.path }.mapValues { (_, all) ->
            JsonObject(all.associate { it.method.lowercase() to operation(it, written.of(it.name)) })
        }
    val info = written.document.getValue("info").jsonObject + ("version" to JsonPrimitive(ProductVersion.text()))
    return JsonObject(written.document + mapOf("info" to JsonObject(info), "paths" to JsonObject(paths)))
}

/** The keys of what is written that OpenAPI has at the same place. */
private val WRITTEN = listOf("tags", "summary", "description", "requestBody")

private fun operation(
    call: ServedCall,
    written: JsonObject,
) = buildJsonObject {
    WRITTEN.forEach { key -> written[key]?.let { put(key, it) } }
    put("operationId", JsonPrimitive(call.id))
    if (call.needsToken) {
        put(
            "security",
            buildJsonArray { add(buildJsonObject { put("token", JsonArray(emptyList())) }) },
        )
    }
    val parameters = call.parameters.map { reference("parameters", it) } + written["parameters"]?.jsonArray.orEmpty()
    if (parameters.isNotEmpty()) put("parameters", JsonArray(parameters))
    val told = written.getValue("responses").jsonObject
    val refused = refusals(call, written).associate { "$it" to reference("responses", PROBLEM) }
    val limited = if (call.isLimited) mapOf("$TOO_MANY" to reference("responses", "Limited")) else emptyMap()
    val away = if (call.isStored) mapOf("$AWAY" to reference("responses", "Unavailable")) else emptyMap()
    val answers = if (call.isLimited) told.mapValues { (_, answer) -> withLimits(answer.jsonObject) } else told
    put("responses", JsonObject((refused + limited + away + answers).toSortedMap()))
}

/** The statuses of refusals: those of every such route, and those that are written. */
private fun refusals(
    call: ServedCall,
    written: JsonObject,
): List<Int> =
    buildList {
        if (call.needsToken) add(UNKNOWN_CALLER)
        if (call.parameters.isNotEmpty()) add(NOTHING_THERE)
        if ("requestBody" in written) addAll(BAD_BODIES)
        written["problems"]?.jsonArray?.forEach { add("$it".toInt()) }
    }

private fun withLimits(answer: JsonObject): JsonObject {
    val headers = LIMIT_HEADERS.associateWith { reference("headers", it) }
    return JsonObject(answer + ("headers" to JsonObject(answer["headers"]?.jsonObject.orEmpty() + headers)))
}

private fun reference(
    kind: String,
    name: String,
): JsonElement = buildJsonObject { put("\$ref", JsonPrimitive("#/components/$kind/$name")) }

/**
 * A method of an address, as the routes have it.
 *
 * @param parameters keys of those in the path, in order: their names, and with `id` whose it is
 * @param needsToken whether only callers who show who they are come in
 * @param isLimited whether callers are told how often they may come
 */
private class ServedCall(
    val method: String,
    val path: String,
    val parameters: List<String>,
    val needsToken: Boolean,
    val isLimited: Boolean,
) {
    val name = "$method $path"

    /** A name for programs that are made from the description. */
    val id =
        method.lowercase() +
            path.removePrefix(API).split(Regex("[^A-Za-z]+")).joinToString("") { it.replaceFirstChar(Char::uppercase) }

    /** Whether the call reads or writes what is stored, which can be away. */
    val isStored = path.startsWith(API) || path == READY

    companion object {
        /** The call that a route is for; null where it is none for programs. */
        fun of(route: RoutingNode): ServedCall? {
            val selectors =
                route
                    .lineage()
                    .map { it.selector }
                    .toList()
                    .asReversed()
            val method = selectors.filterIsInstance<HttpMethodRouteSelector>().singleOrNull() ?: return null
            val path = route.path(OpenApiRoutePathFormat)
            if (!path.startsWith(API) && path !in FOR_MACHINES) return null
            return ServedCall(
                method.method.value,
                path,
                parameters(path),
                selectors.any { it is AuthenticationRouteSelector },
                selectors.any { it is RateLimitRouteSelector },
            )
        }

        private fun parameters(path: String): List<String> =
            path.split("/").zipWithNext().filter { (_, part) -> part.startsWith("{") }.map { (owner, part) ->
                val name = part.removeSurrounding("{", "}")
                if (name == "id") "$owner.id" else name
            }
    }
}

private const val ADDRESS = "/openapi.json"
private const val API = "/api/v1/"
private const val READY = "/readyz"
private val FOR_MACHINES = setOf(ADDRESS, "/healthz", READY, "/metrics")
private const val PROBLEM = "Problem"
private const val UNKNOWN_CALLER = 401
private const val NOTHING_THERE = 404
private const val TOO_MANY = 429
private const val AWAY = 503

/** Refusals of a body: it is not what is expected, too slow, too large, or of another type. */
private val BAD_BODIES = listOf(400, 408, 413, 415)
private val LIMIT_HEADERS = listOf("RateLimit-Policy", "RateLimit-Limit", "RateLimit-Remaining", "RateLimit-Reset")
