package rasterlab.grader.institution

import ch.qos.logback.classic.Level
import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.MACSigner
import com.nimbusds.jose.jwk.RSAKey
import com.nimbusds.jwt.SignedJWT
import com.nimbusds.oauth2.sdk.id.Issuer
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import rasterlab.grader.Classroom
import rasterlab.grader.ServerSettings
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.logging
import rasterlab.grader.one
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse.BodyHandlers
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.Date

/** Signs people in by a provider of OpenID Connect that runs on this machine, and by one that lies. */
@Tag("slow")
class InstitutionSignInTest {
    @TempDir
    lateinit var folder: Path

    private var now = Instant.now()

    private fun room(
        provider: LocalProvider,
        claim: String = "sub",
        column: String = "username",
        staff: Map<String, String> = emptyMap(),
        test: suspend Visit.() -> Unit,
    ) = Classroom(
        folder,
        settings =
            ServerSettings(institution = InstitutionSettings(provider.settings(claim), header = null, column, staff)),
        clock = InstantSource { now },
    ).open(grades = false, test)

    @Test
    @DisplayName("a student whom the institution knows is not let in, or a reader of the log finds the secret")
    fun aStudentComesIn() =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                val seen =
                    logging(Level.DEBUG) { events ->
                        enterAs(this) { "Ada" in it }
                        events.joinToString { it.formattedMessage }
                    }
                assertTrue(LocalProvider.SECRET !in seen, seen)
                assertTrue("Sign in by your institution" in client.get("/").bodyAsText())
            }
        }

    private fun enterAs(
        visit: Visit,
        seen: (String) -> Boolean,
    ) = runBlocking {
        with(visit) {
            val begun = begin()
            val back = follow(begun)
            val entered = back(back, begun.key)
            assertEquals(200, entered.status.value, entered.bodyAsText())
            assertEquals("0; url=/", entered.headers["Refresh"])
            val page = client.get("/exercises") { header(HttpHeaders.Cookie, entered.session()) }
            assertEquals(200, page.status.value)
            assertTrue(seen(page.bodyAsText()))
        }
    }

    @ParameterizedTest(name = "somebody comes in by {argumentSetName}")
    @MethodSource("lies")
    fun aLieIsRefused(lie: LocalProvider.() -> Unit) =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                provider.lie()
                val begun = begin()
                if (begun.place.startsWith("http")) assertRefused(403, back(follow(begun), begun.key))
                assertEquals("0", one("SELECT count(*) FROM sessions"))
            }
        }

    @Test
    @DisplayName("another state, another browser, a second time or a late hour is let in")
    fun anAnswerFitsOneBeginning() =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                val first = begin()
                assertRefused(400, back(follow(first).replace(Regex("state=[^&]+"), "state=x"), first.key))
                val second = begin()
                val third = begin()
                assertRefused(400, back(follow(second), third.key))
                assertRefused(400, back(follow(second), key = null))
                val answer = follow(second)
                assertRefused(400, back("$answer&state=y", second.key))
                val fourth = begin()
                val used = follow(fourth)
                assertEquals(200, back(used, fourth.key).status.value)
                assertRefused(400, back(used, fourth.key))
                val fifth = begin()
                assertRefused(403, back(used.replace(state(used), state(follow(fifth))), fifth.key))
                val sixth = begin()
                now += Duration.ofMinutes(10)
                assertRefused(400, back(follow(sixth), sixth.key))
                assertEquals("1", one("SELECT count(*) FROM sessions"))
            }
        }

    @Test
    @DisplayName("a sign-in that began before a restart, or at another server of the course, is lost")
    fun anotherServerEndsIt() =
        LocalProvider().use { provider ->
            var begun = Beginning("", "")
            room(provider) {
                roster()
                begun = begin()
            }
            room(provider) { assertEquals(200, back(follow(begun), begun.key).status.value) }
        }

    @Test
    @DisplayName("a new key of the provider keeps everybody out")
    fun keysChange() =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                enterAs(this) { true }
                provider.keys = LocalProvider.key()
                enterAs(this) { true }
            }
        }

    @Test
    @DisplayName("the way back leads to another site")
    fun theWayBackStaysHere() =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                for (to in listOf(
                    "//evil.example",
                    "/%5Cevil.example",
                    "https://evil.example",
                    "/a%0d%0aX: y",
                    "/a;url=//evil",
                    "/sign-in/institution",
                )) {
                    val begun = begin("?to=$to")
                    assertEquals("0; url=/", back(follow(begun), begun.key).headers["Refresh"], to)
                }
                val begun = begin("?to=/exercises/draw-dot")
                assertEquals("0; url=/exercises/draw-dot", back(follow(begun), begun.key).headers["Refresh"])
            }
        }

    @Test
    @DisplayName("an address that nobody verified, or whose letters only look alike, lets in")
    fun anAddressIsVerified() =
        LocalProvider().use { provider ->
            room(provider, claim = "email", column = "email") {
                roster()

                suspend fun entered(
                    address: String,
                    verified: Any,
                ): HttpResponse {
                    provider.claims = { claim("email", address).claim("email_verified", verified) }
                    val begun = begin()
                    return back(follow(begun), begun.key)
                }
                assertRefused(403, entered("ada@example.org", false))
                assertRefused(403, entered("ada@example.org", "true"))
                assertRefused(403, entered("k@example.org".replace('k', '\u212a'), true))
                assertEquals(200, entered("ADA@example.org", true).status.value)
            }
        }

    @Test
    @DisplayName("somebody whom no list has comes in, or is not told how they are called")
    fun aStrangerIsTold() =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                provider.person = "<b>eve"
                val begun = begin()
                val page = back(follow(begun), begun.key)
                assertTrue("Your institution calls you: &lt;b&gt;eve" in page.bodyAsText(), page.bodyAsText())
                assertRefused(403, page)
                val russian = begin()
                val said = back("${follow(russian)}&lang=ru", russian.key).bodyAsText()
                assertTrue("Учебное заведение называет вас так" in said, said)
            }
        }

    @Test
    @DisplayName("of two places the wrong one is entered, or one of somebody else")
    fun whoHasTwoPlacesChooses() =
        LocalProvider().use { provider ->
            room(provider) {
                roster()
                roster()
                val others = one("SELECT student_id FROM roster_fields WHERE value = 'k' LIMIT 1")
                val own = one("SELECT max(student_id) FROM roster_fields WHERE value = 'ada'")

                suspend fun chosen(account: String): HttpResponse {
                    val begun = begin()
                    val page = back(follow(begun), begun.key)
                    assertEquals(null, page.headers["Refresh"])
                    return client.post("/sign-in/institution/account") {
                        header(HttpHeaders.Host, "localhost")
                        header(HttpHeaders.Origin, "http://localhost")
                        header(HttpHeaders.Cookie, page.key())
                        header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
                        setBody("account=$account")
                    }
                }
                assertRefused(400, chosen(others))
                assertEquals(200, chosen(own).status.value)
                assertEquals(own, one("SELECT account_id FROM sessions"))
            }
        }

    @Test
    @DisplayName("an instructor of the list is not let in, or is after the access was taken away")
    fun staffComeInByTheList() =
        LocalProvider().use { provider ->
            val staff = mutableMapOf<String, String>()
            room(provider, staff = staff) {
                staff["ada"] = one("SELECT id FROM instructors")
                val begun = begin()
                val entered = back(follow(begun), begun.key)
                val page = client.get("/instructor") { header(HttpHeaders.Cookie, entered.session()) }
                assertEquals(200, page.status.value)
                database.write { it.execute("UPDATE instructors SET revoked_at = '2026-01-01T00:00:00Z'") }
                val again = begin()
                assertRefused(403, back(follow(again), again.key))
            }
        }

    @Test
    @DisplayName("a provider that is away breaks the start page, or is answered with an error of ours")
    fun theProviderIsAway() {
        val provider = LocalProvider().apply { close() }
        room(provider) {
            assertRefused(503, client.get("/sign-in/institution"))
            assertEquals(200, client.get("/").status.value)
        }
    }

    /** @param key the cookie that the browser keeps */
    private class Beginning(
        val place: String,
        val key: String,
    )

    private suspend fun Visit.begin(query: String = ""): Beginning {
        val answer = client.get("/sign-in/institution$query")
        val place = answer.headers[HttpHeaders.Location] ?: return Beginning("", "").also { assertRefused(403, answer) }
        return Beginning(place, answer.key())
    }

    private fun HttpResponse.key() = cookie("rasterlab-institution=")

    private fun HttpResponse.session() = cookie("rasterlab=")

    private fun HttpResponse.cookie(start: String) =
        headers
            .getAll(HttpHeaders.SetCookie)
            .orEmpty()
            .single { it.startsWith(start) }
            .substringBefore(';')

    /** Goes to the provider, as a browser does, up to the way back. */
    private fun follow(begun: Beginning): String {
        val request = HttpRequest.newBuilder(URI(begun.place)).build()
        val place =
            HttpClient
                .newHttpClient()
                .send(request, BodyHandlers.discarding())
                .headers()
                .firstValue("Location")
        return place.get().removePrefix("http://localhost")
    }

    private suspend fun Visit.back(
        path: String,
        key: String?,
    ): HttpResponse = client.get(path) { key?.let { header(HttpHeaders.Cookie, it) } }

    private suspend fun assertRefused(
        status: Int,
        answer: HttpResponse,
    ) {
        assertEquals(status, answer.status.value, answer.bodyAsText())
        assertTrue("You are not signed in" in answer.bodyAsText() || "Вы не вошли" in answer.bodyAsText())
        assertTrue(
            answer.headers
                .getAll(HttpHeaders.SetCookie)
                .orEmpty()
                .none { it.startsWith("rasterlab=") },
        )
    }

    private fun state(path: String) = Regex("state=[^&]+").find(path)?.value.orEmpty()

    private suspend fun Visit.roster() {
        val course = newCourse()
        val answer =
            client.post("/api/v1/courses/$course/roster") {
                bearer(instructor)
                header(HttpHeaders.ContentType, "text/csv")
                setBody("Name,Username,Email\nAda,ada,ada@example.org\nKay,k,k@example.org\n")
            }
        assertEquals(200, answer.status.value, answer.bodyAsText())
    }

    private companion object {
        private fun lie(
            name: String,
            lie: LocalProvider.() -> Unit,
        ): Arguments = argumentSet(name, lie)

        @JvmStatic
        fun lies(): List<Arguments> =
            listOf(
                lie("the nonce of another sign-in") { claims = { claim("nonce", "x") } },
                lie("a token without a nonce") { claims = { claim("nonce", null) } },
                lie("a token for another client") { claims = { audience("another") } },
                lie("the token of another issuer") { claims = { issuer("https://evil.example") } },
                lie("an expired token") { claims = { expirationTime(Date(System.currentTimeMillis() - 120_000)) } },
                lie("a token that nobody signed") { token = LocalProvider::unsigned },
                lie("a key that the provider does not publish") { publishes = LocalProvider.key() },
                lie("a key of the same name") {
                    val own = keys
                    val other = LocalProvider.key()
                    token = { LocalProvider.signed(RSAKey.Builder(other).keyID(own.keyID).build(), it) }
                },
                lie("a token that the client's secret signed") {
                    token = {
                        SignedJWT(JWSHeader(JWSAlgorithm.HS256), it).apply {
                            sign(MACSigner(LocalProvider.SECRET.padEnd(32, ' ')))
                        }
                    }
                },
                lie("discovery of another issuer") { says = Issuer("https://evil.example") },
            )
    }
}
