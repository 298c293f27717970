package rasterlab.grader.web

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.ObjectMapper
import com.fasterxml.jackson.databind.node.ObjectNode
import com.networknt.schema.SchemaRegistry
import com.networknt.schema.SpecificationVersion
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.request
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpMethod
import io.ktor.http.contentType
import io.ktor.http.encodeURLParameter
import io.ktor.http.encodeURLPathPart
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.json
import rasterlab.grader.text
import java.nio.file.Files
import java.nio.file.Path
import kotlin.random.Random

/**
 * Calls every route that the description has, again and again, with values that fit it and values that do not, and
 * holds each answer against it.
 */
@Tag("slow")
class SchemaFuzzTest {
    @TempDir
    lateinit var folder: Path

    private val seed = Random.nextLong()
    private val random = Random(seed)
    private val registry = SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
    private val mapper = ObjectMapper()
    private lateinit var description: JsonNode

    @Test
    @DisplayName("some request is answered by a fault of the server, or by what its description does not have")
    fun everyAnswerIsOneOfThoseDescribed() {
        val wrong = sortedSetOf<String>()
        val met = sortedSetOf<Int>()
        for (share in 0 until SHARES) {
            val own = Files.createDirectories(folder.resolve("$share"))
            Classroom(own, settings = ServerSettings(entriesPerMinute = TIMES / 2)).open { callEach(share, wrong, met) }
        }
        assertEquals("", wrong.joinToString("\n"), "seed $seed")
        assertTrue(
            met.containsAll(listOf(200, 201, 202, 400, 401, 403, 404, 409, 415, 422, 429)),
            "only $met were met",
        )
    }

    /** Calls every route of a share of the paths, and adds what is wrong and the statuses that it met. */
    private suspend fun Visit.callEach(
        share: Int,
        wrong: MutableSet<String>,
        met: MutableSet<Int>,
    ) {
        description = mapper.readTree(client.get("/openapi.json").bodyAsText())
        val known = known()
        val paths = description.path("paths").properties().toList()
        for ((path, methods) in paths.filterIndexed { number, _ -> number % SHARES == share }) {
            for ((method, call) in methods.properties()) {
                repeat(TIMES) {
                    val answer = ask(path, HttpMethod.parse(method.uppercase()), call, known)
                    met += answer.status.value
                    faultOf(answer, call)?.let { wrong += "${method.uppercase()} $path: $it" }
                }
            }
        }
    }

    private suspend fun Visit.ask(
        path: String,
        method: HttpMethod,
        call: JsonNode,
        known: Map<String, List<String>>,
    ): HttpResponse {
        val parameters = call.path("parameters").map(::resolved).groupBy { it.path("in").asText() }
        var address = path
        for (one in parameters["path"].orEmpty()) {
            val name = one.path("name").asText()
            address = address.replace("{$name}", value(name, one, known).ifEmpty { "-" }.encodeURLPathPart())
        }
        val query = parameters["query"].orEmpty().filter { random.nextBoolean() }
        if (query.isNotEmpty()) {
            address +=
                query.joinToString(
                    "&",
                    "?",
                ) { "${it.path("name").asText()}=${value("", it, known).encodeURLParameter()}" }
        }
        return client.request(address) {
            this.method = method
            known
                .getValue("token")
                .random(random)
                .takeIf { it.isNotEmpty() }
                ?.let { bearer(it) }
            for (one in parameters["header"].orEmpty()) {
                if (random.nextInt(4) == 0) header(one.path("name").asText(), "key-${random.nextInt(9)}-of-sixteen")
            }
            val (type, body) = body(call)
            if (body != null) {
                header("Content-Type", type)
                setBody(body)
            }
        }
    }

    private fun value(
        name: String,
        parameter: JsonNode,
        known: Map<String, List<String>>,
    ): String {
        val fitting = parameter.path("schema").path("enum").map { it.asText() } + known[name].orEmpty()
        return if (fitting.isNotEmpty() && random.nextInt(4) > 0) fitting.random(random) else ODD.random(random)
    }

    /** A body of one of the types that are described, or of another, fitting or not. */
    private fun body(call: JsonNode): Pair<String, String?> {
        val content =
            call
                .path("requestBody")
                .path("content")
                .properties()
                .toList()
        if (content.isEmpty()) return "" to null
        val (type, described) = content.random(random)
        val text =
            when {
                random.nextInt(6) == 0 -> MALFORMED.random(random)
                type == "application/json" -> fitting(described.path("schema")).toString()
                type.startsWith("multipart") -> FORM
                else -> "class Dot { }"
            }
        val told = if (type.startsWith("multipart")) "$type; boundary=b" else type
        return (if (random.nextInt(8) == 0) TYPES.random(random) else told) to text
    }

    /** A value of that schema, in which now and then something is wrong. */
    private fun fitting(schema: JsonNode): JsonNode {
        val whole = resolved(schema)
        if (random.nextInt(8) == 0) return mapper.readTree(VALUES.random(random))
        return when (whole.path("type").asText()) {
            "object" -> {
                val made = mapper.createObjectNode()
                whole.path("properties").properties().forEach { (name, of) ->
                    if (random.nextInt(10) > 0) made.set<JsonNode>(name, fitting(of))
                }
                made
            }

            "string" -> {
                mapper.valueToTree(WORDS.random(random))
            }

            "integer", "number" -> {
                mapper.valueToTree(random.nextInt(-2, 99))
            }

            else -> {
                mapper.readTree(VALUES.random(random))
            }
        }
    }

    private fun resolved(node: JsonNode): JsonNode {
        val to = node.path("${'$'}ref").asText("")
        return if (to.isEmpty()) node else description.at(to.removePrefix("#"))
    }

    /** Tells what of an answer is not as the description of the call has it; null where all is. */
    private suspend fun faultOf(
        answer: HttpResponse,
        call: JsonNode,
    ): String? {
        val status = answer.status.value
        val body = answer.bodyAsText()
        if (status >= 500) return "$status $body"
        val described =
            call.path("responses").get("$status")?.let(::resolved) ?: return "$status is not described: $body"
        for ((name, header) in described.path("headers").properties()) {
            val told = answer.headers[name]
            val whole = resolved(header)
            if (told == null && whole.path("required").asBoolean()) return "$status has no header $name"
            val faults = registry.getSchema(whole.path("schema")).validate(mapper.valueToTree<JsonNode>(told.orEmpty()))
            if (told != null && faults.isNotEmpty()) return "$status: $name is $told"
        }
        val content = described.path("content")
        if (content.isEmpty) return null
        val type = answer.contentType()?.withoutParameters().toString()
        val schema =
            content
                .properties()
                .firstOrNull { it.key.substringBefore(';') == type }
                ?.value
                ?.path("schema")
        if (schema ==
            null
        ) {
            return "$status is of type $type, described are ${content.fieldNames().asSequence().toList()}"
        }
        if (!type.endsWith("json")) return null
        val whole = mapper.createObjectNode()
        (resolved(schema) as? ObjectNode)?.let { whole.setAll<JsonNode>(it) }
        whole.set<JsonNode>("components", description.path("components"))
        val errors = registry.getSchema(whole).validate(mapper.readTree(body))
        return if (errors.isEmpty()) null else "$status does not fit: $errors"
    }

    private companion object {
        const val TIMES = 60

        /** Servers among which the paths are shared out, since each may be visited for a minute alone. */
        const val SHARES = 3

        val ODD =
            listOf(
                "nothing",
                "a b",
                "..",
                "a/b",
                "%00",
                "%",
                "'; DROP TABLE students; --",
                "x".repeat(300),
                "\uD83D\uDE00",
                "Ж",
                "null",
                "0",
                "-1",
                "<b>",
                "a\tb",
                "\u202E",
                "en,ru",
                "line-bresenham",
            )
        val WORDS =
            ODD + listOf("Ada", "Computer graphics", "2027-03-01T20:00:00Z", "2027-13-01T20:00:00Z", "", "\u0000")
        val VALUES =
            listOf("null", "true", "0", "1e400", "-0.0", "\"\"", "[]", "{}", "[[[[[[[[]]]]]]]]", "{\"a\":{\"a\":1}}")
        val MALFORMED =
            listOf(
                "",
                "{",
                "{\"name\":",
                "[1,",
                "\u0000",
                "{\"name\":\"a\"} {}",
                "name=a",
                "\uFEFF{}",
                "[".repeat(5000),
            )
        val TYPES =
            listOf(
                "text/plain",
                "application/json; charset=utf-16",
                "application/xml",
                "a/b; c=\"",
                "multipart/form-data",
            )
        const val FORM = "--b\r\nContent-Disposition: form-data; name=\"source\"\r\n\r\nclass Dot { }\r\n--b--\r\n"
    }
}
