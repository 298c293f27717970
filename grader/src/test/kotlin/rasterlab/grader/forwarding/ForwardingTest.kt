package rasterlab.grader.forwarding

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Wire
import java.net.InetAddress
import java.nio.file.Path

/** Asks through a real socket, whose other end is this machine: a proxy where it is called one. */
@Tag("slow")
class ForwardingTest {
    @TempDir
    lateinit var folder: Path

    private fun room(vararg proxies: String) =
        Classroom(
            folder,
            settings = ServerSettings(entriesPerMinute = 1, proxies = proxies.map(InetAddress::getByName).toSet()),
        )

    private fun Wire.join(vararg forwarded: String) =
        send(
            "POST",
            "/api/v1/join",
            "Content-Type: application/json",
            *forwarded,
            body = "{}".toByteArray(),
        ).statusCode()

    @Test
    @DisplayName("whoever writes X-Forwarded-For has no limit on guesses")
    fun nobodyElseIsBelieved() =
        room("192.0.2.7").listen {
            assertEquals(listOf(400, 429), listOf("203.0.113.1", "203.0.113.2").map { join("X-Forwarded-For: $it") })
        }

    @Test
    @DisplayName("all who come through a proxy share one limit")
    fun aProxyTellsItsClients() =
        room("127.0.0.1").listen {
            assertEquals(400, join("X-Forwarded-For: 203.0.113.1"))
            assertEquals(400, join("X-Forwarded-For: 203.0.113.2"))
            assertEquals(429, join("X-Forwarded-For: 203.0.113.1"))
        }

    @Test
    @DisplayName("what a client writes before its proxy's word counts, or a name that it writes is looked up")
    fun theAddressNearestToTheServerCounts() =
        room("127.0.0.1", "192.0.2.7").listen {
            assertEquals(400, join("X-Forwarded-For: 203.0.113.8, 203.0.113.1, 192.0.2.7"))
            assertEquals(429, join("X-Forwarded-For: 203.0.113.9, 203.0.113.1"))
            assertEquals(400, join("X-Forwarded-For: name.invalid"))
            assertEquals(429, join())
        }

    @Test
    @DisplayName("a sign-in over a proxy's TLS may go back in plain text, or plain HTTP never signs in")
    fun theCookieIsSecureWhereTheProxyHasTls() {
        fun Wire.cookie(vararg forwarded: String) =
            send(
                "POST",
                "/sign-in",
                "Content-Type: application/x-www-form-urlencoded",
                *forwarded,
                "Origin: http://127.0.0.1:$port",
                body = "token=${newStudent()}".toByteArray(),
            ).headers().firstValue("Set-Cookie").orElse("none")
        room("127.0.0.1").listen {
            val cookie = cookie("X-Forwarded-Proto: https", "X-Forwarded-For: 203.0.113.1")
            assertTrue("Secure" in cookie && "HttpOnly" in cookie, cookie)
            assertTrue("Secure" !in cookie("X-Forwarded-For: 203.0.113.2"), "plain HTTP")
        }
    }

    @Test
    @DisplayName("a proxy is called by a name, or the text after a comma is left out")
    fun proxiesAreAddresses() {
        val two = setOf("127.0.0.1", "::1").map(InetAddress::getByName).toSet()
        assertEquals(two, Forwarding.proxies("127.0.0.1, ::1"))
        for (none in listOf(
            "localhost",
            "127.0.0.1,",
            "",
            "127.0.0.300",
        )) {
            assertEquals(null, Forwarding.proxies(none), none)
        }
    }
}
