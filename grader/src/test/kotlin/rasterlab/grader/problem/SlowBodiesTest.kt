package rasterlab.grader.problem

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Wire.Companion.JSON
import java.io.IOException
import java.net.Socket
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds

/** Senders that never finish and never stop; the timeout ends only a test whose server neither reads nor closes. */
@Tag("slow")
@Timeout(300)
class SlowBodiesTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "{argumentSetName} holds its connection for ever")
    @MethodSource("requests")
    fun hangsUp(
        status: Int,
        head: List<String>,
        begin: String,
    ) = Classroom(folder, settings = ServerSettings(bodyPatience = 100.milliseconds)).listen {
        connect().use { socket ->
            val lines = head + listOf("Host: localhost", "Authorization: Bearer ${newStudent()}", "", begin)
            socket.getOutputStream().write(lines.joinToString("\r\n").toByteArray())
            val answer =
                generateSequence(
                    socket.getInputStream().bufferedReader()::readLine,
                ).takeWhile { it != "" }.toList()
            assertTrue(answer.first().startsWith("HTTP/1.1 $status "), answer.first())
            assertEquals(status == 408, answer.any { it.equals("Connection: close", ignoreCase = true) })
            assertThrows(IOException::class.java) { sendMuchMore(socket) }
        }
    }

    /** Well-made pieces of a chunked body, which any other body may hold as well. */
    private fun sendMuchMore(socket: Socket) {
        val piece = "10000\r\n${"a".repeat(0x10000)}\r\n".toByteArray()
        repeat(4_096) { socket.getOutputStream().write(piece) }
    }

    companion object {
        private const val SUBMIT = "POST /api/v1/exercises/draw-dot/submissions HTTP/1.1"
        private const val JAVA = "Content-Type: text/x-java-source"
        private const val FORM = "Content-Type: multipart/form-data; boundary=x"
        private const val FIELD = "--x\r\nContent-Disposition: form-data; name=\"source\"\r\n\r\nclass"
        private const val LONG = "Content-Length: 1000000000"

        @JvmStatic
        fun requests(): List<Arguments> =
            listOf(
                argumentSet("source of a told length", 408, listOf(SUBMIT, JAVA, LONG), "class"),
                argumentSet(
                    "source in pieces",
                    408,
                    listOf(SUBMIT, JAVA, "Transfer-Encoding: chunked"),
                    "5\r\nclass\r\n",
                ),
                argumentSet("form", 408, listOf(SUBMIT, FORM, LONG), FIELD),
                argumentSet("JSON", 408, listOf("POST /api/v1/join HTTP/1.1", JSON, LONG), "{"),
                argumentSet("body of no use", 403, listOf("POST /api/v1/courses HTTP/1.1", JSON, LONG), "{"),
                argumentSet("body for a wrong method", 405, listOf("PUT /api/v1/join HTTP/1.1", JSON, LONG), "{"),
            )
    }
}
