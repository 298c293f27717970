package rasterlab.grader.problem

import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.score.Message
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.api.describedApi
import rasterlab.grader.assertProblem
import rasterlab.grader.bearer
import rasterlab.grader.course.Name
import rasterlab.grader.course.Staff
import rasterlab.grader.course.StaffRole
import rasterlab.grader.json
import rasterlab.grader.list
import rasterlab.grader.one
import rasterlab.grader.submission.Leases
import rasterlab.grader.text
import rasterlab.grader.worker.Worker
import rasterlab.grader.worker.Workers
import java.nio.file.Path
import java.time.InstantSource

/** Each list that grows is read in parts, all in the same way. */
@Tag("slow")
class PagingTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("the last part says that there is more, an empty list fails, or an unknown id begins at the beginning")
    fun aPartEndsWhereTheListDoes() {
        val all = listOf("a", "b", "c")
        val parts =
            listOf(null, "a", "b", "c").map { after ->
                Paging(after, 2).of(all) { it }.let { "${it.items.joinToString("")} ${it.next}" }
            }
        assertEquals(listOf("ab b", "bc null", "c null", " null"), parts)
        assertEquals(all, Paging(after = null, Paging.WHOLE).of(all) { it }.items)
        assertEquals(null, Paging(after = null).of(emptyList<String>()) { it }.next)
        assertThrows(Rejection.Malformed::class.java) { Paging("d").of(all) { it } }
    }

    @Test
    @DisplayName("a list has no parts, parts that overlap or leave something out, or takes any limit or id")
    fun everyListHasParts() =
        Classroom(folder, more = (listOf("draw-line") + EXAMS).map(Classroom::another)).open {
            val place = place()
            val api = describedApi()
            val paged = api.paths.keys.filter { Paging.LIMIT in api.parameters(it, "get") }
            assertEquals(paged.map { it.removePrefix(API) }.toSet(), LISTS.keys.map(::plain).toSet())
            for ((list, key) in LISTS) {
                val path = API + place.entries.fold(list) { filled, (name, id) -> filled.replace("{$name}", id) }
                val token = place.getValue(if (list == "/exams") "token" else "instructor")
                val whole = items(look(token, path), key)
                assertTrue(whole.size >= 2, "$path: $whole")
                assertEquals(whole, walk(token, path, key), path)
                for (wrong in WRONG) look(token, with(path, wrong)).assertProblem(400, "malformed-request")
            }
        }

    @Test
    @DisplayName("a score that is sent while parts are read moves, so that others are left out or come twice")
    fun partsOfScoresFitWhileTheyAreSent() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            repeat(4) { newStudent(course) }
            scores()
            val path = "$API/courses/$course/lti/scores"
            assertEquals(4, items(look(instructor, path), "").size)
            val read =
                walk(instructor, path, "") { part ->
                    val student =
                        part
                            .single()
                            .getValue("student")
                            .jsonPrimitive.content
                    database.write { it.execute("UPDATE lti_scores SET due_at = NULL WHERE student_id = ?", student) }
                }
            assertEquals(4, read.map { it.getValue("student") }.toSet().size, "$read")
        }

    /** A score of each student at one link of a platform, which waits. */
    private suspend fun Visit.scores() {
        send("/lti/platforms", platform("scores"))
        database.write { handle ->
            handle.execute(
                """INSERT INTO lti_links (id, platform_id, context, link, exercise, line_item)
                   SELECT 'l', id, '7', '9', 'draw-dot', 'https://m.example/1' FROM lti_platforms
                   WHERE client_id = 'scores'""",
            )
            handle.execute(
                """INSERT INTO lti_scores
                   (link_id, student_id, exercise, points, points_of, version, changed_at, due_at)
                   SELECT 'l', id, 'draw-dot', 8, 10, 1, '$LATER', '$LATER' FROM students""",
            )
        }
    }

    private suspend fun Visit.walk(
        token: String,
        path: String,
        key: String,
        meanwhile: (List<Map<String, JsonElement>>) -> Unit = {},
    ): List<Map<String, JsonElement>> {
        val read = mutableListOf<Map<String, JsonElement>>()
        var next: String? = with(path, "limit=1")
        while (next != null && read.size < MANY) {
            val answer = look(token, next)
            val part = items(answer, key)
            assertEquals(1, part.size, next)
            read += part
            meanwhile(part)
            next = answer.headers[HttpHeaders.Link]?.substringAfter('<')?.substringBefore(">; rel=\"next\"")
        }
        return read
    }

    private suspend fun items(
        answer: HttpResponse,
        key: String,
    ): List<Map<String, JsonElement>> {
        val body = Json.parseToJsonElement(answer.bodyAsText())
        return (body as? JsonArray ?: (body as JsonObject).list(key)).map { it.jsonObject - MOVING }
    }

    private fun with(
        path: String,
        query: String,
    ) = path + (if ('?' in path) "&" else "?") + query

    /** The address as the description has it. */
    private fun plain(list: String) =
        list.substringBefore('?').replace("{submission}", "{id}").replace("{exercise}", "{id}")

    /** A course in which there are two of everything. */
    private suspend fun Visit.place(): Map<String, String> {
        val staff = Staff(database, InstantSource.system())
        val assistant = staff.add(Name.of("Grace"), StaffRole.ASSISTANT, by = "test", key = null).token
        val code = newCourse()
        newCourse()
        val (token, other) = List(2) { newStudent(code) }
        val id = submit(token).json().text("id")
        eventsToTheEnd(token, id)
        eventsToTheEnd(other, submit(other, exercise = "draw-line").json().text("id"))
        for (case in listOf("open-case", "hidden-case")) {
            send("/submissions/$id/complaints", """{"case":"$case","text":"Why?"}""", token)
        }
        for (exercise in listOf("draw-dot", "draw-line")) {
            send("/submissions/$id/comments", """{"text":"Why?"}""", token)
            send("/courses/$code/kept-comments", """{"name":"$exercise","text":"So."}""", assistant)
            send("/courses/$code/exercises/$exercise/regrade", """{"of":"all"}""")
            send("/lti/platforms", platform(exercise))
            client.post("$API/submissions/$id/trials") {
                bearer(assistant)
                header(HttpHeaders.ContentType, "text/x-java-source")
                setBody("class Dot { }")
            }
        }
        scores()
        database.write { handle ->
            handle.execute("INSERT INTO hints SELECT id, 'draw-dot', 1, 2, '$LATER' FROM students")
        }
        EXAMS.forEach { send("/courses/$code/exams", exam(it)) }
        val workers = Workers(database, InstantSource.system(), Leases.LENGTH)
        for (name in listOf("ada", "eve")) {
            workers.begin(Worker(name, "host", serves = false, Message.of("isolation.plain"), slots = 1))
        }
        return mapOf(
            "course" to code,
            "submission" to id,
            "exercise" to "draw-dot",
            "token" to token,
            "instructor" to instructor,
            "exam" to one("SELECT min(id) FROM exams"),
        )
    }

    private suspend fun Visit.send(
        path: String,
        body: String,
        by: String = instructor,
    ) {
        val answer =
            client.post(API + path) {
                bearer(by)
                json(body)
            }
        assertTrue(answer.status.value in 200..299, "$path: ${answer.bodyAsText()}")
    }

    private companion object {
        const val API = "/api/v1"
        const val MANY = 100
        const val LATER = "2037-03-01T12:00:00.000Z"
        val EXAMS = listOf("first-exam", "second-exam")

        /** Fields that change while something is graded. */
        val MOVING = setOf("state", "verdict", "points", "of", "done", "failed", "settledAt", "grading", "seenAt")
        val WRONG = listOf("limit=0", "limit=1001", "limit=two", "limit=", "after=none", "after=")

        /** The lists, each with the name of what it lists; empty where the answer is an array. */
        val LISTS =
            mapOf(
                "/courses" to "courses",
                "/courses/{course}/submissions" to "submissions",
                "/courses/{course}/students" to "",
                "/courses/{course}/exercises" to "exercises",
                "/courses/{course}/exams" to "",
                "/courses/{course}/complaints" to "complaints",
                "/courses/{course}/questions" to "questions",
                "/courses/{course}/regrades" to "",
                "/courses/{course}/kept-comments" to "",
                "/exams" to "",
                "/exams/{exam}" to "students",
                "/exercises?lang=ru" to "",
                "/staff" to "",
                "/workers" to "",
                "/audit" to "entries",
                "/lti/platforms" to "",
                "/submissions/{submission}/comments" to "comments",
                "/submissions/{submission}/complaints" to "",
                "/submissions/{submission}/trials" to "",
                "/courses/{course}/exercises/{exercise}/hints" to "",
                "/courses/{course}/lti/scores" to "",
            )

        fun exam(exercise: String) =
            """{"name":"Exam","exercises":["$exercise"],"opens":"2037-03-01T10:00","closes":"2037-03-01T12:00",
               "minutes":30,"grace":30}"""

        fun platform(client: String) =
            "https://moodle.example.org".let {
                """{"name":"Moodle","issuer":"$it","clientId":"$client","deployment":"1","loginUrl":"$it/a",
                   "tokenUrl":"$it/t","keysUrl":"$it/k"}"""
            }
    }
}
