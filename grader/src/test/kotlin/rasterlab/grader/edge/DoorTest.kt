package rasterlab.grader.edge

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Wire
import java.net.Socket
import java.nio.file.Path

/** Checks what a client sees on the wire; the timeout ends only a test whose server neither reads nor closes. */
@Tag("slow")
@Timeout(300)
class DoorTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "{0} bytes to close after take the answer away")
    @ValueSource(ints = [300_000, 11_000_000])
    fun tellsThatABodyIsTooLargeToWhoeverSendsAllOfIt(size: Int) =
        Classroom(folder).listen {
            val head =
                listOf(
                    "POST /api/v1/exercises/draw-dot/submissions HTTP/1.1",
                    "Host: localhost",
                    "Authorization: Bearer ${newStudent()}",
                    "Content-Type: text/x-java-source",
                    "Content-Length: $size",
                    "Connection: close",
                )
            connect().use { socket ->
                socket.send(head.joinToString("\r\n", postfix = "\r\n\r\n"))
                socket.getOutputStream().write(ByteArray(size) { 'a'.code.toByte() })
                assertEquals("HTTP/1.1 413 Payload Too Large", socket.answers().first())
            }
        }

    @ParameterizedTest(name = "a connection goes on after {0}")
    @ValueSource(strings = ["Content-Length: 5", "Transfer-Encoding: gzip", "X : y"])
    fun endsAConnectionWhoseRequestsMayBeReadInTwoWays(header: String) =
        Classroom(folder).listen {
            connect().use { socket ->
                val first = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n"
                val both =
                    "POST /api/v1/join HTTP/1.1\r\nHost: localhost\r\n$header\r\n" +
                        "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n"
                socket.send(first + both + first)
                val statuses = socket.answers().filter { it.startsWith("HTTP/") }
                assertEquals(listOf("HTTP/1.1 200 OK", "HTTP/1.1 400 Bad Request"), statuses)
            }
        }

    @ParameterizedTest(name = "{argumentSetName} is stored as if it were whole")
    @MethodSource("partBodies")
    fun storesNoPartOfABody(
        header: String,
        body: String,
    ) = Classroom(folder).listen {
        connect().use { socket ->
            val head =
                listOf(
                    "POST /api/v1/exercises/draw-dot/submissions HTTP/1.1",
                    "Host: localhost",
                    "Authorization: Bearer ${newStudent()}",
                    "Content-Type: text/x-java-source",
                    header,
                )
            socket.send(head.joinToString("\r\n", postfix = "\r\n\r\n") + body)
            socket.shutdownOutput()
            assertEquals("HTTP/1.1 400 Bad Request", socket.answers().first())
            val stored =
                database.read {
                    it
                        .createQuery(
                            "SELECT count(*) FROM submissions",
                        ).mapTo(Int::class.java)
                        .one()
                }
            assertEquals(0, stored)
        }
    }

    @Test
    fun countsTheConnectionsOfAnAddress() = refusesOneMoreThan(4, DoorLimits(all = 100, perAddress = 4))

    @Test
    fun countsAllConnections() = refusesOneMoreThan(4, DoorLimits(all = 4, perAddress = 100))

    private fun refusesOneMoreThan(
        most: Int,
        limits: DoorLimits,
    ) = Classroom(folder).listen(limits) {
        val open = List(most) { connect() }
        open.forEach { assertEquals("HTTP/1.1 200 OK", it.health()) }
        connect().use { socket ->
            val answer = socket.answers()
            assertEquals("HTTP/1.1 503 Service Unavailable", answer.first())
            assertTrue(
                "Retry-After: 5" in answer && answer.last().startsWith("{\"type\":\"urn:rasterlab:problem:"),
                "$answer",
            )
        }
        open.forEach { assertEquals("HTTP/1.1 200 OK", it.health(), "one that was let in") }
        open.first().close()
        assertEquals("HTTP/1.1 200 OK", generateSequence { connect().use { it.health() } }.first { "503" !in it })
        open.forEach(Socket::close)
    }

    @ParameterizedTest(name = "{argumentSetName} is answered for the wrong reader")
    @MethodSource("readers")
    fun tellsPeopleOnAPageAndProgramsInJson(
        head: String,
        type: String,
        words: String,
    ) = Classroom(folder).listen {
        connect().use { socket ->
            socket.send("$head\r\nContent-Length: 1\r\nTransfer-Encoding: chunked\r\n\r\n")
            val answer = socket.answers()
            assertEquals("HTTP/1.1 400 Bad Request", answer.first())
            assertTrue("Content-Type: $type" in answer && answer.any { words in it }, "$answer")
        }
    }

    @Test
    fun aPersonWhoIsOneTooManyReadsAPage() =
        Classroom(folder).listen(DoorLimits(all = 1, perAddress = 1)) {
            connect().use { first ->
                assertEquals("HTTP/1.1 200 OK", first.health())
                connect().use { socket ->
                    socket.send("GET / HTTP/1.1\r\nHost: localhost\r\n$BROWSER\r\n\r\n")
                    val answer = socket.answers()
                    assertEquals("HTTP/1.1 503 Service Unavailable", answer.first())
                    assertTrue("Retry-After: 5" in answer && "слишком много открытых" in answer.last(), "$answer")
                }
            }
        }

    @Test
    fun keepsAnsweringWhenManyHaveComeAndGone() =
        Classroom(folder).listen(DoorLimits(all = 8, perAddress = 8)) {
            repeat(200) { connect().use { socket -> socket.send("GET /hea") } }
            assertEquals("HTTP/1.1 200 OK", generateSequence { connect().use { it.health() } }.first { "503" !in it })
        }

    @Test
    fun limitsEachClientByItsOwnAddress() =
        Classroom(folder, settings = ServerSettings(entriesPerMinute = 1)).listen {
            val joins = List(2) { status("POST", "/api/v1/join", Wire.JSON, "Content-Length: 0") }
            assertEquals(listOf("400", "429"), joins.map { it.split(' ')[1] })
            val other = status("POST", "/api/v1/join", Wire.JSON, "Content-Length: 0", from = "127.0.0.2")
            assertEquals("400", other.split(' ')[1], "another address pays for this one")
        }

    private fun Socket.health(): String {
        send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n")
        val lines = getInputStream().bufferedReader()
        val head = generateSequence(lines::readLine).takeWhile { it.isNotEmpty() }.toList()
        val length = head.firstOrNull { it.startsWith("Content-Length: ") }?.substringAfter(": ")?.toInt() ?: 0
        repeat(length) { lines.read() }
        return head.firstOrNull().orEmpty().ifEmpty { "503 closed" }
    }

    private fun Socket.send(text: String) = getOutputStream().write(text.toByteArray())

    /** All lines until the server ends the connection. */
    private fun Socket.answers(): List<String> = getInputStream().bufferedReader().readLines()

    companion object {
        private const val BROWSER = "Accept: text/html,*/*;q=0.8\r\nAccept-Language: de, ru;q=0.7, en;q=0.5"
        private const val PAGE = "text/html; charset=utf-8"
        private const val PROBLEM = "application/problem+json"

        @JvmStatic
        fun readers() =
            listOf(
                argumentSet("a browser", "POST /x HTTP/1.1\r\n$BROWSER", PAGE, "Сервер не смог"),
                argumentSet("an English one", "POST /x?lang=en HTTP/1.1\r\n$BROWSER", PAGE, "could not read what"),
                argumentSet(
                    "one by its cookie",
                    "POST / HTTP/1.1\r\n$BROWSER\r\nCookie: a=b; lang=en",
                    PAGE,
                    "could not",
                ),
                argumentSet("a bad header's browser", "POST / HTTP/1.1\r\nX : y\r\n$BROWSER", PAGE, "Сервер не смог"),
                argumentSet("a program", "POST /x HTTP/1.1\r\nAccept: */*", PROBLEM, "malformed-request"),
                argumentSet("the API in a browser", "POST /api/v1/join HTTP/1.1\r\n$BROWSER", PROBLEM, "malformed-req"),
            )

        @JvmStatic
        fun partBodies() =
            listOf(
                argumentSet("part of a told length", "Content-Length: 50", "class A {}"),
                argumentSet("some of the pieces", "Transfer-Encoding: chunked", "a\r\nclass A {}\r\n"),
                argumentSet("a broken piece", "Transfer-Encoding: chunked", "a\r\nclass A {}\r\nx\r\n"),
            )
    }
}
