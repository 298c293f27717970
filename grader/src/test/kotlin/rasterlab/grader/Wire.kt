package rasterlab.grader

import ch.qos.logback.classic.Level
import ch.qos.logback.classic.Logger
import ch.qos.logback.classic.spi.ILoggingEvent
import ch.qos.logback.core.read.ListAppender
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import org.slf4j.LoggerFactory
import rasterlab.grader.course.Courses
import rasterlab.grader.course.Name
import rasterlab.grader.storage.Database
import java.net.InetAddress
import java.net.Socket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpRequest.BodyPublishers
import java.net.http.HttpResponse
import java.net.http.HttpResponse.BodyHandlers
import java.time.InstantSource

/** A server's socket, and what is sent through it byte for byte. */
class Wire(
    val port: Int,
    val database: Database,
    val instructor: String,
) {
    private val client = HttpClient.newHttpClient()

    /** @param headers "Name: value" each */
    fun send(
        method: String,
        path: String,
        vararg headers: String,
        body: ByteArray = ByteArray(0),
    ): HttpResponse<String> {
        val request = HttpRequest.newBuilder(URI("http://127.0.0.1:$port$path"))
        headers.forEach { request.header(it.substringBefore(": "), it.substringAfter(": ")) }
        return client.send(request.method(method, BodyPublishers.ofByteArray(body)).build(), BodyHandlers.ofString())
    }

    fun course(
        body: ByteArray,
        vararg headers: String,
    ) = send("POST", "/api/v1/courses", "Authorization: Bearer $instructor", *headers, body = body)

    /**
     * A student joined behind the server's back, whose limits on requests are the tests' own
     * matter.
     */
    fun newStudent(): String {
        val courses = Courses(database, InstantSource.system())
        val course = courses.create(by = "i", Name.of("Graphics"), key = null)
        return courses.join(course.code, Name.of("Ada"), key = null).token
    }

    /** The first line of the answer to a request that ends its connection. */
    fun status(
        method: String,
        target: String,
        vararg headers: String,
        from: String = "127.0.0.1",
    ): String =
        connect(from).use { socket ->
            val lines = listOf("$method $target HTTP/1.1", "Host: localhost", "Connection: close", *headers, "", "")
            socket.getOutputStream().write(lines.joinToString("\r\n").toByteArray())
            socket.getInputStream().bufferedReader().readLine()
        }

    fun connect(from: String = "127.0.0.1") =
        Socket(InetAddress.getByName("127.0.0.1"), port, InetAddress.getByName(from), 0).apply {
            soTimeout = PATIENCE_MILLIS
        }

    companion object {
        const val JSON = "Content-Type: application/json"

        /** A server that hangs fails the test instead of holding it up. */
        private const val PATIENCE_MILLIS = 120_000
    }
}

/** Gives [test] what the server logs meanwhile at [level] or above. */
fun <T> logging(
    level: Level,
    test: (List<ILoggingEvent>) -> T,
): T {
    val root = LoggerFactory.getLogger("rasterlab.grader") as Logger
    val events = ListAppender<ILoggingEvent>().apply { start() }
    val usual = root.level
    root.level = level
    root.addAppender(events)
    try {
        return test(events.list)
    } finally {
        root.detachAppender(events)
        root.level = usual
    }
}

fun HttpResponse<String>.header(name: String): String? = headers().firstValue(name).orElse(null)

/** The answer is a whole problem document of this status; returns its detail. */
fun HttpResponse<String>.assertProblem(
    status: Int,
    type: String,
): String {
    assertProblem(status, type, statusCode(), header("Content-Type"), body())
    return Json.parseToJsonElement(body()).jsonObject.text("detail")
}
