package rasterlab.grader.api

import io.ktor.server.auth.authenticate
import io.ktor.server.routing.RoutingNode
import io.ktor.server.routing.get
import io.ktor.server.routing.routing
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.engine.ProductVersion
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import java.nio.file.Path

class ApiDescriptionTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("a route for programs is not described, or one is that there is not")
    fun describesTheRoutesThereAreAndNoOthers() =
        Classroom(folder).open(grades = false) {
            val described =
                describedApi().paths.flatMap { (path, methods) ->
                    methods.jsonObject.keys.map { "${it.uppercase()} ${plain(path)}" }
                }
            assertEquals(listed().sorted(), described.sorted())
        }

    @Test
    @DisplayName("a new route is passed over where nobody wrote about it")
    fun aRouteThatNobodyWroteAboutIsAFault() =
        Classroom(folder).open(grades = false) {
            val root = with("/api/v1/moon")
            val failure = assertThrows(IllegalStateException::class.java) { describe(root) }
            assertTrue("GET /api/v1/moon is served" in failure.message.orEmpty(), failure.message)
        }

    @Test
    @DisplayName("a route that went away is still described")
    fun whatIsWrittenAboutNoRouteIsAFault() =
        Classroom(folder).open(grades = false) {
            val written = WrittenOperations.read()
            val more =
                WrittenOperations(written.operations + ("GET /api/v1/moon" to JsonObject(emptyMap())), written.document)
            val root = with(path = null)
            val failure = assertThrows(IllegalStateException::class.java) { describe(root, more) }
            assertTrue("no route serves [GET /api/v1/moon]" in failure.message.orEmpty(), failure.message)
        }

    @Test
    @DisplayName("who must sign in, the parameters of the path, or the refusals that follow from a route are not told")
    fun tellsWhatFollowsFromTheRoute() =
        Classroom(folder).open(grades = false) {
            val api = describedApi()
            for ((path, methods) in api.paths) {
                for ((method, call) in methods.jsonObject) {
                    val place = "$method $path"
                    val inPath = Regex("""\{(\w+)}""").findAll(path).map { it.groupValues[1] }.toList()
                    assertEquals(inPath, api.parameters(path, method).take(inPath.size), place)
                    val statuses =
                        call.jsonObject
                            .getValue("responses")
                            .jsonObject.keys
                    val known = path.startsWith("/api/") && path != "/api/v1/join"
                    assertEquals(known, "security" in call.jsonObject, place)
                    assertEquals(known, "401" in statuses, place)
                    assertEquals(path.startsWith("/api/") || path == "/readyz", "503" in statuses, place)
                    if (inPath.isNotEmpty()) assertTrue("404" in statuses, place)
                    if ("requestBody" in call.jsonObject) assertTrue(statuses.containsAll(BODY), place)
                }
            }
            val join =
                api.paths
                    .getValue("/api/v1/join")
                    .jsonObject
                    .getValue("post")
                    .jsonObject
            val answers = join.getValue("responses").jsonObject
            assertEquals("#/components/responses/Limited", answers.getValue("429").jsonObject["\$ref"]?.text())
            assertTrue("RateLimit-Remaining" in "${answers["201"]}", "${answers["201"]}")
        }

    @Test
    @DisplayName("a reference leads nowhere, or a schema that nothing uses is kept")
    fun everyReferenceLeadsSomewhere() =
        Classroom(folder).open(grades = false) {
            val api = describedApi()
            val named = references(api.document).toSet()
            named.forEach { api.whole(JsonObject(mapOf("\$ref" to it))) }
            val schemas =
                api.document
                    .getValue("components")
                    .jsonObject
                    .getValue("schemas")
                    .jsonObject.keys
            val used = named.map { it.text().substringAfterLast("/") }.toSet()
            assertEquals(emptySet<String>(), schemas - used)
        }

    @Test
    fun namesTheVersionThatTheBuildGave() =
        Classroom(folder).open(grades = false) {
            val info = describedApi().document.getValue("info").jsonObject
            assertEquals(ProductVersion.text(), info.getValue("version").text())
            assertTrue(ProductVersion.text().matches(Regex("""\d+\.\d+\.\d+.*""")), ProductVersion.text())
        }

    /** The root of the server's routes, to which one more is added. */
    private suspend fun Visit.with(path: String?): RoutingNode {
        lateinit var root: RoutingNode
        application.application {
            root = routing { if (path != null) authenticate { get(path) { } } } as RoutingNode
        }
        application.startApplication()
        return root
    }

    /** The calls for programs in the list of all routes that says what each role is answered. */
    private fun listed(): List<String> {
        val list = checkNotNull(javaClass.getResource("/rasterlab/grader/course/routes.txt")).readText()
        return list
            .lines()
            .mapNotNull { Regex("""([A-Z]+) (\S+) \d.*""").matchEntire(it)?.destructured }
            .filter { (_, path) -> path.startsWith("/api/") || path in FOR_MACHINES }
            .map { (method, path) -> "$method ${plain(path)}" }
            .distinct()
    }

    private fun plain(path: String) = path.replace(Regex("""\{\w+}"""), "{}").substringBefore("?")

    private fun references(told: JsonElement): List<JsonElement> =
        when (told) {
            is JsonObject -> told.flatMap { (key, value) -> if (key == "\$ref") listOf(value) else references(value) }
            is JsonArray -> told.jsonArray.flatMap(::references)
            else -> emptyList()
        }

    private fun JsonElement.text() = jsonPrimitive.content

    private companion object {
        val FOR_MACHINES = setOf("/openapi.json", "/healthz", "/readyz", "/metrics")
        val BODY = setOf("400", "408", "413", "415")
    }
}
