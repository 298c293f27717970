package rasterlab.grader.institution

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
class ProxyHeaderTest {
    @TempDir
    lateinit var folder: Path

    private fun room(
        proxy: String,
        test: Wire.() -> Unit,
    ) {
        val staff = mutableMapOf<String, String>()
        val settings = InstitutionSettings(provider = null, "X-Remote-User", "username", staff)
        Classroom(
            folder,
            settings = ServerSettings(proxies = setOf(InetAddress.getByName(proxy)), institution = settings),
        ).listen {
            staff["ada"] =
                database.read { it.createQuery("SELECT id FROM instructors").mapTo(String::class.java).one() }
            test()
        }
    }

    private fun Wire.enter(vararg headers: String) = send("GET", "/sign-in/institution", *headers)

    @Test
    @DisplayName("whom the proxy names is not let in")
    fun theProxyIsBelieved() =
        room("127.0.0.1") {
            val entered = enter("X-Remote-User: ada")
            assertEquals(200, entered.statusCode(), entered.body())
            val session = entered.headers().allValues("Set-Cookie").single { it.startsWith("rasterlab=") }
            assertEquals(200, send("GET", "/instructor", "Cookie: ${session.substringBefore(';')}").statusCode())
        }

    @Test
    @DisplayName("anybody who writes the header comes in")
    fun nobodyElseIsBelieved() =
        room("192.0.2.7") {
            val refused = enter("X-Remote-User: ada")
            assertEquals(403, refused.statusCode())
            assertTrue(refused.headers().allValues("Set-Cookie").none { it.startsWith("rasterlab=") })
        }

    @Test
    @DisplayName("a client's header beside the proxy's own counts, or an empty one")
    fun oneNameIsTold() =
        room("127.0.0.1") {
            assertEquals(403, enter("X-Remote-User: ada", "X-Remote-User: eve").statusCode())
            assertEquals(403, enter("X-Remote-User: ada, eve").statusCode())
            assertEquals(403, enter("X-Remote-User:  ").statusCode())
            assertEquals(403, enter().statusCode())
        }

    @Test
    @DisplayName("the way back from a provider is open where a header names people")
    fun thereIsNoOtherWay() =
        room("127.0.0.1") { assertEquals(400, send("GET", "/sign-in/institution/back?code=a&state=b").statusCode()) }
}
