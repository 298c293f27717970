package rasterlab.grader.problem

import ch.qos.logback.classic.Level
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.MethodSource
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.grader.Classroom
import rasterlab.grader.Wire.Companion.JSON
import rasterlab.grader.assertProblem
import rasterlab.grader.logging
import java.nio.file.Path

/** Headers that no well-made program sends. */
@Tag("slow")
class HeadersTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "content type ''{0}'' is taken for a failure of the server")
    @ValueSource(strings = [";;;", "text", "text/", "a/b/c", "multipart/form-data;;;"])
    fun refusesABodyOfNoType(type: String) =
        Classroom(folder).listen {
            val student = "Authorization: Bearer ${newStudent()}"
            val named = "Content-Type: $type"
            val source = "class A {}".toByteArray()
            logging(Level.WARN) { logged ->
                val submission = send("POST", "/api/v1/exercises/draw-dot/submissions", student, named, body = source)
                assertTrue(submission.statusCode() in setOf(400, 415), submission.body())
                val detail = course("""{"name":"x"}""".toByteArray(), named).assertProblem(415, "wrong-media-type")
                assertEquals("Content-Type is '$type', expected application/json", detail)
                assertEquals(emptyList<Any>(), logged)
            }
        }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("requests")
    fun answersInSpiteOfAHeader(
        path: String,
        status: Int,
        header: String,
    ) = Classroom(folder).listen {
        logging(Level.WARN) { logged ->
            val token = "Authorization: Bearer $instructor"
            val answer =
                if (header.startsWith(
                        "Authorization",
                    )
                ) {
                    send("GET", path, header)
                } else {
                    send("GET", path, token, header)
                }
            assertEquals(status, answer.statusCode(), answer.body())
            assertEquals(emptyList<Any>(), logged)
        }
    }

    @ParameterizedTest(name = "''{0}'' is taken for a failure of the server")
    @CsvSource("/?lang=%zz, 400", "/api/v1/exercises?lang=%zz, 400", "/api/v1/exercises/%zz, 400", "/exercises/%, 400")
    fun answersInSpiteOfAnAddress(
        target: String,
        status: Int,
    ) = Classroom(folder).listen {
        logging(Level.WARN) { logged ->
            val answer = status("GET", target, "Authorization: Bearer $instructor")
            assertTrue(answer.startsWith("HTTP/1.1 $status "), answer)
            assertEquals(emptyList<Any>(), logged)
        }
    }

    @Test
    fun answersInJsonAfterACourseWasMade() =
        Classroom(folder).listen {
            for (wish in listOf("Accept: application/xml", "Accept: text", "Accept-Charset: ;;")) {
                val answer = course("""{"name":"x"}""".toByteArray(), JSON, wish)
                assertEquals(201, answer.statusCode(), "$wish: the course is there and its code is not told")
            }
        }

    companion object {
        private const val LIST = "/api/v1/exercises"
        private const val PAGE = "/"

        @JvmStatic
        fun requests() =
            listOf(
                argumentSet("language list of signs", LIST, 200, "Accept-Language: ;;;,q=,"),
                argumentSet("page in a language list of signs", PAGE, 200, "Accept-Language: ;;;,q=,"),
                argumentSet("character set of no name", LIST, 200, "Accept-Charset: ;;"),
                argumentSet("media type without a slash", LIST, 200, "Accept: text"),
                argumentSet("session that ends in a percent sign", PAGE, 200, "Cookie: rasterlab=%"),
                argumentSet("language cookie that is not hexadecimal", PAGE, 200, "Cookie: lang=%zz"),
                argumentSet("cookies of signs", PAGE, 200, "Cookie: ;;;=\""),
                argumentSet("broken session at a page for students", "/exercises", 401, "Cookie: rasterlab=%zz"),
                argumentSet("range that ends before it begins", "/assets/rasterlab.css", 200, "Range: bytes=5-1"),
                argumentSet("tag of open quotes", "/assets/rasterlab.css", 200, "If-None-Match: \"\"\""),
                argumentSet("scheme without a token", LIST, 401, "Authorization: Bearer"),
                argumentSet("token of two words", LIST, 401, "Authorization: Bearer a b"),
                argumentSet("scheme of no name", LIST, 401, "Authorization: ,=\""),
                argumentSet("event id that is none", "/api/v1/submissions/none/events", 404, "Last-Event-ID: ;;"),
            )
    }
}
