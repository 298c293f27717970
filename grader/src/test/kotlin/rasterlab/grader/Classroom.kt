package rasterlab.grader

import io.ktor.client.HttpClient
import io.ktor.client.request.HttpRequestBuilder
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.server.testing.ApplicationTestBuilder
import io.ktor.server.testing.testApplication
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import rasterlab.engine.raster.Pixel
import rasterlab.engine.raster.PixelWindow
import rasterlab.exercises.Exercise
import rasterlab.exercises.Grading
import rasterlab.exercises.StatementPicture
import rasterlab.exercises.runner.Isolation
import rasterlab.exercises.score.CasePicture
import rasterlab.exercises.score.CaseReport
import rasterlab.exercises.score.Disclosure
import rasterlab.exercises.score.GradingVerdict
import rasterlab.exercises.score.Message
import rasterlab.exercises.score.PicturePart
import rasterlab.exercises.score.Report
import rasterlab.exercises.score.ScorePoints
import rasterlab.grader.edge.DoorLimits
import rasterlab.grader.edge.Listening
import rasterlab.grader.exercise.Exercises
import rasterlab.grader.postgres.TestDatabases
import rasterlab.grader.storage.Database
import rasterlab.grader.submission.SteadyClock
import java.net.InetAddress
import java.net.InetSocketAddress
import java.nio.file.Path
import java.sql.DriverManager
import java.time.InstantSource
import java.util.Optional
import javax.net.ssl.SSLContext

/** A server on a real database of [folder], an SQLite file as a rule, graded by [grading]. */
class Classroom(
    val folder: Path,
    private val grading: Grading =
        Grading {
            _,
            _,
            _,
            progress,
            ->
            wrongReport().also { it.cases().forEach(progress::accept) }
        },
    private val settings: ServerSettings = ServerSettings(),
    private val exercise: Exercise = EXERCISE,
    private val more: List<Exercise> = emptyList(),
    private val kept: (String, String) -> Exercise? = { _, _ -> null },
    private val clock: InstantSource = InstantSource.system(),
    private val nanos: () -> Long = System::nanoTime,
    private val isolation: () -> Isolation = { ISOLATION },
) {
    val file: Path = folder.resolve("test.db")

    /** @param grades whether submissions are graded; otherwise they wait */
    fun open(
        grades: Boolean = true,
        test: suspend Visit.() -> Unit,
    ) = serve { server, database, token ->
        if (grades) server.startGrading()
        testApplication {
            application { server.install(this) }
            Visit(this, database, token).test()
        }
    }

    /** Listens behind a real socket, for what is only seen on the wire; nothing is graded. */
    fun listen(
        limits: DoorLimits = DoorLimits(),
        encryption: SSLContext? = null,
        test: Wire.() -> Unit,
    ) = serve { server, database, token ->
        val address = InetSocketAddress(InetAddress.getLoopbackAddress(), 0)
        Listening(
            address,
            limits,
            encryption,
        ) { server.install(this, it) }.use { Wire(it.port, database, token).test() }
    }

    private fun serve(use: (Server, Database, String) -> Unit) =
        TestDatabases.open(folder).use { database ->
            val exercises = Exercises(listOf(exercise) + more, kept)
            val steady = SteadyClock(clock, nanos)
            Server(database, exercises, grading, isolation, settings, clock, steady).use { server ->
                val token = server.accounts.newInstructorToken() ?: "an earlier visit got it"
                server.accounts.instructorAnnounced()
                use(server, database, token)
            }
        }

    companion object {
        const val DOT = "<svg xmlns='http://www.w3.org/2000/svg'><rect width='9' height='9'/></svg>"

        val EXERCISE =
            Exercise(
                "draw-dot",
                "line",
                mapOf("en" to "Draw a dot", "ru" to "Нарисуйте точку"),
                mapOf(
                    "en" to
                        "Light **one** pixel at \$x_0\$ for 5 \$. <script>alert(1)</script>\n\n" +
                        "![one pixel](dot.svg)\n\n\$\\includegraphics{/etc/hostname}\$\n",
                    "ru" to "Зажгите **один** пиксель.",
                ),
                mapOf("dot.svg" to StatementPicture.of("dot.svg", DOT.toByteArray())),
                "public class Dot {}\n",
                "r1",
                Exercise.ExerciseTolerance(true),
                Exercise.PointPlan(6, 3, 1),
                listOf(
                    Exercise.Case(
                        "open-case",
                        mapOf("en" to "one pixel", "ru" to "один пиксель"),
                        Exercise.Criterion.ACCURACY,
                        Disclosure.OPEN,
                        5,
                        "{}",
                        false,
                    ),
                ),
            )

        val ISOLATION =
            Isolation(
                Report.PROCESS_LIMITS,
                Message.of("isolation.plain"),
                listOf(Message.of("missing.no-bwrap")),
                false,
            )

        /** An exercise like [EXERCISE] under another name. */
        fun another(id: String) =
            Exercise(
                id,
                EXERCISE.topic(),
                mapOf("en" to "The task $id", "ru" to "Задание $id"),
                mapOf("en" to "Light it.", "ru" to "Зажгите его."),
                emptyMap(),
                EXERCISE.starter(),
                "r1",
                Exercise.ExerciseTolerance(true),
                EXERCISE.points(),
                EXERCISE.cases(),
            )

        fun wrongReport() = report(GradingVerdict.WRONG, ScorePoints(4, 0, 0, 10))

        fun report(
            verdict: GradingVerdict,
            points: ScorePoints,
        ) = Report(
            verdict,
            points,
            listOf(case("open-case", Disclosure.OPEN, verdict), case("hidden-case", Disclosure.VERDICT_ONLY, verdict)),
            emptyList(),
            "process limits only",
            12.5,
        )

        fun case(
            name: String,
            visibility: Disclosure,
            verdict: GradingVerdict,
        ) = CaseReport(
            name,
            visibility,
            verdict,
            2,
            5,
            Message.quoted("secret of $name <img src=x onerror=alert(1)>").and(Message.of("pixel.missing", "(1, 2)")),
            listOf("expected" to "#.#.", "actual" to "##..", "difference" to "#+-.").mapIndexed { number, (kind, row) ->
                CasePicture(kind, byteArrayOf((number + 1).toByte()), Message.rows("a part\n$row"), Optional.of(part()))
            } + CasePicture("input", byteArrayOf(4), Message.of("pixel.extra", "(-1, 2)"), Optional.empty()),
            """{"from":[0,0],"to":[3,1]}""",
        )

        private fun part() = PicturePart(PixelWindow(-2, 1, 1, 1), PixelWindow(-2, 1, 99, 1), Pixel(-1, 1))
    }
}

/** The actions of the people of a test. */
class Visit(
    val application: ApplicationTestBuilder,
    val database: Database,
    val instructor: String,
) {
    val client: HttpClient by lazy { application.createClient { followRedirects = false } }

    suspend fun newCourse(): String =
        client
            .post("/api/v1/courses") {
                bearer(instructor)
                json("""{"name":"Graphics"}""")
            }.json()
            .text("code")

    suspend fun newStudent(course: String? = null): String {
        val code = course ?: newCourse()
        return client.post("/api/v1/join") { json("""{"course":"$code","name":"Ada"}""") }.json().text("token")
    }

    suspend fun submit(
        token: String,
        source: String = "class Dot {}",
        key: String? = null,
        late: Boolean = false,
        exercise: String = "draw-dot",
    ): HttpResponse =
        client.post("/api/v1/exercises/$exercise/submissions" + if (late) "?late=accept" else "") {
            bearer(token)
            header(HttpHeaders.ContentType, "text/x-java-source")
            key?.let { header("Idempotency-Key", it) }
            setBody(source)
        }

    suspend fun look(
        token: String,
        path: String,
    ): HttpResponse = client.get(path) { bearer(token) }

    /** The events of a submission until its result is in. */
    suspend fun eventsToTheEnd(
        token: String,
        id: String,
    ): List<Pair<String, JsonObject>> =
        look(token, "/api/v1/submissions/$id/events").bodyAsText().trim().split(Regex("(\r?\n){2}")).map { block ->
            val lines = block.lines()
            val data = lines.single { it.startsWith("data:") }.removePrefix("data:").trim()
            lines.single { it.startsWith("event:") }.removePrefix("event:").trim() to
                Json.parseToJsonElement(data).jsonObject
        }
}

fun HttpRequestBuilder.bearer(token: String) = header(HttpHeaders.Authorization, "Bearer $token")

fun HttpRequestBuilder.json(body: String) {
    header(HttpHeaders.ContentType, "application/json")
    setBody(body)
}

suspend fun HttpResponse.json(): JsonObject = Json.parseToJsonElement(bodyAsText()).jsonObject

fun JsonObject.text(key: String): String = getValue(key).jsonPrimitive.content

fun JsonObject.list(key: String): JsonArray = getValue(key).jsonArray

fun JsonElement.field(key: String): String = jsonObject.text(key)

/** A browser in which this token's holder has signed in, by its cookie. */
suspend fun Visit.cookieOf(token: String): String {
    val entered =
        client.post("/sign-in") {
            header(HttpHeaders.Host, "localhost")
            header(HttpHeaders.Origin, "http://localhost")
            header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
            setBody("token=$token")
        }
    return checkNotNull(entered.headers[HttpHeaders.SetCookie]) { "${entered.status}" }.substringBefore(';')
}

/** Sends a page's form, as [by] does who has signed in. */
suspend fun Visit.sendForm(
    path: String,
    body: String,
    by: String = instructor,
): HttpResponse {
    val cookie = cookieOf(by)
    return client.post(path) {
        header(HttpHeaders.Cookie, cookie)
        header(HttpHeaders.Host, "localhost")
        header(HttpHeaders.Origin, "http://localhost")
        header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
        setBody(body)
    }
}

/** The one value that the server's database answers with. */
fun Visit.one(sql: String): String = database.read { it.createQuery(sql).mapTo(String::class.java).one() }

/** The answer is a whole problem document of this status. */
suspend fun HttpResponse.assertProblem(
    status: Int,
    type: String,
) {
    assertProblem(status, type, this.status.value, headers[HttpHeaders.ContentType], bodyAsText())
}

fun assertProblem(
    status: Int,
    type: String,
    found: Int,
    contentType: String?,
    body: String,
) {
    assertEquals(status, found, body)
    assertEquals("application/problem+json", contentType)
    val problem = Json.parseToJsonElement(body).jsonObject
    assertEquals(setOf("type", "title", "status", "detail"), problem.keys)
    assertEquals("urn:rasterlab:problem:$type", problem.text("type"), body)
    assertEquals(status.toString(), problem.text("status"))
    check(problem.text("detail").isNotBlank() && "Exception" !in body && "\tat " !in body) { "not for people: $body" }
}

/** The first value that a connection of its own reads from the database, as another process would. */
fun query(
    file: Path,
    sql: String,
): String =
    DriverManager.getConnection("jdbc:sqlite:$file").use { connection ->
        connection.createStatement().executeQuery(sql).run {
            next()
            getString(1)
        }
    }
