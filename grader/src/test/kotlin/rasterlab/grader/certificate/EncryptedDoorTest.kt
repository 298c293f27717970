package rasterlab.grader.certificate

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.Timeout
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Wire
import rasterlab.grader.edge.DoorLimits
import java.io.InputStream
import java.io.OutputStream
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.net.SocketException
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpRequest.BodyPublishers
import java.net.http.HttpResponse
import java.net.http.HttpResponse.BodyHandlers
import java.nio.file.Path
import java.time.InstantSource
import java.util.concurrent.CompletableFuture
import javax.net.ssl.SSLParameters
import javax.net.ssl.SSLSocket
import kotlin.concurrent.thread

/** Calls a server that encrypts by a certificate of its own, as browsers and programs do. */
@Tag("slow")
@Timeout(300)
class EncryptedDoorTest {
    @TempDir
    lateinit var folder: Path

    private lateinit var made: MadeCertificate

    @BeforeEach
    fun makeCertificate() {
        made = MadeCertificate.make(folder, "server")
    }

    private fun listen(
        limits: DoorLimits = DoorLimits(),
        by: MadeCertificate = made,
        test: Wire.() -> Unit,
    ) {
        val encryption = OwnCertificate.read(by.certificate, by.key, InstantSource.system()).encryption()
        Classroom(folder, settings = ServerSettings(encrypted = true)).listen(limits, encryption, test)
    }

    private fun client(
        protocol: String,
        by: MadeCertificate = made,
    ) = HttpClient
        .newBuilder()
        .sslContext(by.trusting)
        .sslParameters(SSLParameters().apply { protocols = arrayOf(protocol) })
        .build()

    private fun HttpClient.call(
        port: Int,
        path: String,
        body: ByteArray? = null,
        vararg headers: String,
    ): HttpResponse<String> {
        val request = HttpRequest.newBuilder(URI("https://127.0.0.1:$port$path"))
        headers.forEach { request.header(it.substringBefore(": "), it.substringAfter(": ")) }
        body?.let { request.POST(BodyPublishers.ofByteArray(it)) }
        return send(request.build(), BodyHandlers.ofString())
    }

    @ParameterizedTest(name = "nobody is answered by a certificate of kind {0} with {1}")
    @CsvSource("EC, TLSv1.3", "EC, TLSv1.2", "RSA, TLSv1.3", "RSA, TLSv1.2", "Ed25519, TLSv1.3")
    fun clientsAreAnswered(
        kind: String,
        protocol: String,
    ) {
        val by = MadeCertificate.make(folder, "kind", kind)
        listen(by = by) {
            val client = client(protocol, by)
            assertEquals(listOf(200, "ok\n"), client.call(port, "/healthz").run { listOf(statusCode(), body()) })
            val description = client.call(port, "/openapi.json").body()
            assertTrue("openapi" in Json.parseToJsonElement(description).jsonObject, "it is cut")
        }
    }

    @Test
    @DisplayName("a body that is larger than a record of TLS is cut, or its answer is lost")
    fun largeBodiesArrive() =
        listen {
            val source = "class Dot {}\n" + "// wide\n".repeat(3_000)
            val token = "Authorization: Bearer ${newStudent()}"
            val path = "/api/v1/exercises/draw-dot/submissions"
            val client = client("TLSv1.3")
            val stored = client.call(port, path, source.toByteArray(), token, "Content-Type: text/x-java-source")
            assertEquals(202, stored.statusCode(), stored.body())
            val id = Regex("\"id\":\"([^\"]+)\"").find(stored.body())!!.groupValues[1]
            assertEquals(source, client.call(port, "/api/v1/submissions/$id/source", null, token).body())
            val refused = client.call(port, path, ByteArray(2_000_000), token, "Content-Type: text/x-java-source")
            assertEquals(413, refused.statusCode(), refused.body())
        }

    @Test
    @DisplayName("many who come at once, or come back, are kept waiting by one another")
    fun manyAtOnceAreAnswered() =
        listen {
            val calls =
                List(40) { CompletableFuture.supplyAsync { client("TLSv1.3").call(port, "/healthz").statusCode() } }
            assertEquals(List(40) { 200 }, calls.map { it.join() })
        }

    @Test
    @DisplayName("a session's cookie may go back over plain HTTP")
    fun cookiesAreSecure() =
        listen {
            val form = "token=$instructor".toByteArray()
            val origin = "Origin: https://127.0.0.1:$port"
            val type = "Content-Type: application/x-www-form-urlencoded"
            val signedIn = client("TLSv1.3").call(port, "/sign-in", form, origin, type)
            val cookie = signedIn.headers().firstValue("Set-Cookie").orElse("none, ${signedIn.statusCode()}")
            assertTrue("; Secure" in cookie, cookie)
        }

    @Test
    @DisplayName("who types http:// is cut off without a word")
    fun clearTextIsTold() =
        listen {
            val answer =
                connect().use {
                    it.getOutputStream().write("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n".toByteArray())
                    it.getInputStream().bufferedReader().readLines()
                }
            assertEquals("HTTP/1.1 400 Bad Request", answer.first())
            assertTrue("begin with https://" in answer.last(), "$answer")
        }

    @Test
    @DisplayName("one too many is cut off instead of being told so")
    fun oneTooManyIsTold() =
        listen(DoorLimits(all = 1, perAddress = 1)) {
            connect().use {
                val refused = client("TLSv1.3").call(port, "/healthz")
                assertEquals(503, refused.statusCode())
                assertEquals("5", refused.headers().firstValue("Retry-After").orElse("none"))
            }
        }

    @ParameterizedTest(name = "a client of {0} whose bytes come one by one is not understood")
    @ValueSource(strings = ["TLSv1.2", "TLSv1.3"])
    fun singleBytesAreEnough(protocol: String) =
        listen {
            ByteWise(port).use { relay ->
                assertEquals("ok\n", client(protocol).call(relay.port, "/healthz").body())
            }
        }

    @Test
    @DisplayName("what a slow reader has not taken yet is lost or mixed up")
    fun slowReadersGetAll() =
        listen {
            val once = client("TLSv1.3").call(port, "/openapi.json").body()
            val request = "GET /openapi.json HTTP/1.1\r\nHost: localhost\r\n"
            val socket = made.trusting.socketFactory.createSocket("127.0.0.1", port) as SSLSocket
            socket.use {
                it.soTimeout = PATIENCE_MILLIS
                val requests = "$request\r\n".repeat(ANSWERS - 1) + "${request}Connection: close\r\n\r\n"
                it.outputStream.write(requests.toByteArray())
                val all = String(it.inputStream.readAllBytes())
                assertEquals(ANSWERS, all.split(once).size - 1)
            }
        }

    /** A way to [target] that hands on one byte at a time. */
    private class ByteWise(
        target: Int,
    ) : AutoCloseable {
        private val server = ServerSocket(0, 1, InetAddress.getLoopbackAddress())
        val port = server.localPort
        private val taking =
            thread {
                server.accept().use { client ->
                    Socket(server.inetAddress, target).use { behind ->
                        val back = thread { copy(behind.getInputStream(), client.getOutputStream()) }
                        copy(client.getInputStream(), behind.getOutputStream())
                        behind.close()
                        back.join()
                    }
                }
            }

        private fun copy(
            from: InputStream,
            to: OutputStream,
        ) = try {
            generateSequence { from.read().takeIf { it >= 0 } }.forEach {
                to.write(it)
                to.flush()
            }
        } catch (ended: SocketException) {
            // one of the two has closed
        }

        override fun close() = server.close()
    }

    private companion object {
        const val ANSWERS = 60
        const val PATIENCE_MILLIS = 120_000
    }
}
