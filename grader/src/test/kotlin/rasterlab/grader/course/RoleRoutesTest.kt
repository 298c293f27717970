package rasterlab.grader.course

import io.ktor.client.request.HttpRequestBuilder
import io.ktor.client.request.header
import io.ktor.client.request.prepareRequest
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsChannel
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.HttpMethod
import io.ktor.server.routing.HttpMethodRouteSelector
import io.ktor.server.routing.RoutingNode
import io.ktor.server.routing.RoutingRoot
import io.ktor.server.routing.getAllRoutes
import io.ktor.server.routing.routing
import io.ktor.utils.io.cancel
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.json
import rasterlab.grader.one
import rasterlab.grader.text
import java.nio.file.Path
import java.time.InstantSource

/**
 * Asks for every route as nobody, as the student whom it is about, as another student of the course, as an assistant and
 * as an instructor; what each is answered stands in routes.txt, which has a line for every route there is.
 */
@Tag("slow")
class RoleRoutesTest {
    @TempDir
    lateinit var folder: Path

    /**
     * @param part the heading that it stands under
     * @param body what is sent, with the names of [Place] in it; empty for nothing
     */
    private class Row(
        val part: String,
        val method: String,
        val path: String,
        val statuses: List<String>,
        val body: String,
    ) {
        val isPage = !path.startsWith("/api/")
    }

    /** Where rows are tried, until one changes something: some of the people lose what they have. */
    private class Place(
        val tokens: List<String?>,
        val ids: Map<String, String>,
    ) {
        val cookies = HashMap<String, String>()

        fun fill(text: String) = ids.entries.fold(text) { filled, (name, id) -> filled.replace("{$name}", id) }
    }

    @Test
    @DisplayName("a route has no line, or a line has no route")
    fun everyRouteHasALine() =
        Classroom(folder).open(grades = false) {
            val served = sortedSetOf<String>()
            application.application {
                routing { served += (this as RoutingRoot).getAllRoutes().mapNotNull(::call) }
            }
            application.startApplication()
            assertEquals(
                served.joinToString("\n"),
                rows().map { "${it.method} ${it.path}" }.sorted().joinToString("\n"),
            )
        }

    @ParameterizedTest(name = "somebody is answered what is not theirs, or refused what is: {0}")
    @MethodSource("parts")
    fun eachRoleIsAnsweredAsTheTableSays(part: String) =
        Classroom(folder, settings = ServerSettings(entriesPerMinute = 100_000)).open {
            val rows = rows().filter { it.part == part }
            var place = place()
            val found =
                rows.map { row ->
                    val statuses = place.tokens.map { "${status(row, place, it)}" }
                    if (row.method != "GET") place = place()
                    line(row, statuses)
                }
            assertEquals(rows.joinToString("\n") { line(it, it.statuses) }, found.joinToString("\n"))
        }

    @Test
    @DisplayName("staff of another course are answered what belongs to this one, or to the whole server")
    fun othersCoursesAreClosed() =
        Classroom(folder, settings = ServerSettings(entriesPerMinute = 100_000)).open {
            val place = place()
            newCourse()
            val other = one("SELECT id FROM courses WHERE id <> '${place.ids["course"]}'")
            val staff = Staff(database, InstantSource.system())
            for (role in StaffRole.entries) {
                val token = staff.add(Name.of("Alan"), role, by = "test", key = null, other).token
                val answered =
                    rows().filter { row ->
                        val status = status(row, place, token)
                        if (row.path == "/sign-out") place.cookies.clear()
                        status !in setOf(403, 404)
                    }
                assertEquals(
                    emptyList<String>(),
                    answered.map { "${it.method} ${it.path}" }.filterNot { OF_NO_COURSE.matches(it) },
                )
                assertEquals(emptySet<String>(), OWN - answered.map { it.path }.toSet())
            }
        }

    private fun line(
        row: Row,
        statuses: List<String>,
    ) = (listOf(row.method, row.path) + statuses + row.body).joinToString(" ").trim()

    private suspend fun Visit.status(
        row: Row,
        place: Place,
        token: String?,
    ): Int {
        val cookie = if (row.isPage && token != null) place.cookies.getOrPut(token) { cookieOf(token) } else null
        return client
            .prepareRequest(place.fill(row.path)) {
                method = HttpMethod.parse(row.method)
                if (row.isPage) asForm(cookie) else token?.let { bearer(it) }
                if (row.body.isNotEmpty()) send(row, place.fill(row.body))
            }.execute { answer ->
                if (row.path == UNENDING && answer.status.value == 200) leave(answer)
                answer.status.value
            }
    }

    /** Goes away from events that never end, and lets the server notice by the next one. */
    private suspend fun Visit.leave(answer: HttpResponse) {
        answer.bodyAsChannel().cancel(null)
        submit(newStudent())
    }

    private fun HttpRequestBuilder.asForm(cookie: String?) {
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.Origin, "http://localhost")
        cookie?.let { header(HttpHeaders.Cookie, it) }
    }

    private fun HttpRequestBuilder.send(
        row: Row,
        body: String,
    ) {
        val type =
            when {
                row.isPage && body.startsWith("--b") -> "multipart/form-data; boundary=b"
                row.isPage -> "application/x-www-form-urlencoded"
                body.startsWith("{") -> "application/json"
                body.startsWith("class") -> "text/x-java-source"
                else -> "text/csv"
            }
        header(HttpHeaders.ContentType, type)
        setBody(body.replace("\\r", "\r").replace("\\n", "\n"))
    }

    private suspend fun Visit.place(): Place {
        val made =
            client
                .prepareRequest("/api/v1/courses") {
                    method = HttpMethod.Post
                    bearer(instructor)
                    json("""{"name":"Graphics"}""")
                }.execute { it.json() }
        val staff = Staff(database, InstantSource.system())
        val assistants = List(2) { staff.add(Name.of("Grace"), StaffRole.ASSISTANT, by = "test", key = null) }
        val student = newStudent(made.text("code"))
        val others = List(2) { newStudent(made.text("code")) }
        val submissions = listOf(student, others[0]).map { it to submit(it).json().text("id") }
        submissions.forEach { (token, id) -> eventsToTheEnd(token, id) }
        val question =
            client
                .prepareRequest("/api/v1/submissions/${submissions[0].second}/comments") {
                    method = HttpMethod.Post
                    bearer(student)
                    json("""{"text":"Why?"}""")
                }.execute { it.json() }
        val id = checkNotNull(Accounts(database, InstantSource.system()).holder(student)).id
        return Place(
            listOf(null, student, others[0], assistants[0].token, instructor),
            mapOf(
                "course" to made.text("course"),
                "code" to made.text("code"),
                "exercise" to "draw-dot",
                "submission" to submissions[0].second,
                "first" to submissions[0].second,
                "second" to submissions[1].second,
                "student" to id,
                "staff" to assistants[1].id,
                "token" to others[1],
                "regrade" to "none",
                "worker" to "none",
                "platform" to "none",
                "adjustment" to "none",
                "exam" to "none",
                "comment" to question.text("id"),
                "trial" to copy(submissions[0].second),
                "other" to submissions[0].second,
                "complaint" to complaint(student, submissions[0].second),
                "kept" to "none",
                "group" to "none",
                "case" to "open-case",
                "picture" to "actual.png",
                "name" to "dot.svg",
                "..." to "rasterlab.css",
            ),
        )
    }

    /** A complaint about a case of that submission. */
    private suspend fun Visit.complaint(
        student: String,
        submission: String,
    ): String =
        client
            .prepareRequest("/api/v1/submissions/$submission/complaints") {
                method = HttpMethod.Post
                bearer(student)
                json("""{"case":"open-case","text":"Why?"}""")
            }.execute { it.json().text("id") }

    /** A copy of that submission that is graded. */
    private suspend fun Visit.copy(submission: String): String {
        val copy =
            client
                .prepareRequest("/api/v1/submissions/$submission/trials") {
                    method = HttpMethod.Post
                    bearer(instructor)
                    header(HttpHeaders.ContentType, "text/x-java-source")
                    setBody("class Dot { }")
                }.execute { it.json().text("id") }
        val cookie = cookieOf(instructor)
        client
            .prepareRequest("/instructor/trials/$copy/events") { header(HttpHeaders.Cookie, cookie) }
            .execute { it.bodyAsText() }
        return copy
    }

    private fun call(route: RoutingNode): String? {
        val selector = route.selector as? HttpMethodRouteSelector ?: return null
        val path = route.parent.toString().replace(Regex("""/\([^)]*\)"""), "")
        val id = if ("/submissions/{id}" in path) "{submission}" else "{exercise}"
        return "${selector.method.value} ${path.replace("{id}", id).ifEmpty { "/" }}"
    }

    private companion object {
        const val ROLES = 5
        const val UNENDING = "/instructor/events"

        /** The addresses that show each of the staff what is theirs. */
        val OWN =
            setOf("/instructor", "/instructor/latest", UNENDING, "/exercises", "/api/v1/exercises", "/api/v1/courses")

        /** The addresses that are for everybody, or show each what is theirs. */
        val OF_NO_COURSE =
            Regex(
                """GET /api/v1/courses|[A-Z]+ (/|/(sign|lti)[-/].*|/join|/api/v1/join|/assets/.*""" +
                    """|/(healthz|readyz|metrics|openapi.json)""" +
                    """|(/api/v1)?/exercises|(/api/v1)?/exercises/.exercise.(/(starter|statement|pictures/.name.))?""" +
                    """|/instructor(/(latest|events|view/end))?)""",
            )

        /** Each heading has a server of its own. */
        @JvmStatic
        fun parts(): List<String> = rows().map { it.part }.distinct()

        fun rows(): List<Row> {
            val lines =
                checkNotNull(
                    RoleRoutesTest::class.java.getResource("routes.txt"),
                ) { "no routes.txt" }.readText()
            var part = ""
            return lines.lines().mapNotNull { line ->
                if (line.startsWith("## ")) part = line.removePrefix("## ")
                if (line.isBlank() || line.startsWith("#")) null else row(part, line)
            }
        }

        private fun row(
            part: String,
            line: String,
        ): Row {
            val parts = line.split(" ", limit = 2 + ROLES + 1)
            check(parts.size >= 2 + ROLES) { "expected METHOD PATH and $ROLES statuses, got: $line" }
            return Row(part, parts[0], parts[1], parts.subList(2, 2 + ROLES), parts.getOrElse(2 + ROLES) { "" })
        }
    }
}
