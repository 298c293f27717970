package rasterlab.grader.lti

import com.nimbusds.jose.crypto.RSASSAVerifier
import com.nimbusds.jose.jwk.JWKSet
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.SignedJWT
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.bearer
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.one
import rasterlab.grader.sendForm
import java.nio.file.Path
import java.time.Instant
import java.time.InstantSource

/** Follows what changes after a platform was registered: a student's name there, and this server's own key. */
@Tag("slow")
class LaterChangesTest {
    @TempDir
    lateinit var folder: Path

    private var now = Instant.now()

    private fun room(test: suspend Visit.(LocalPlatform) -> Unit) =
        LocalPlatform().use { platform ->
            Classroom(folder, clock = InstantSource { now }).open(grades = false) { test(platform) }
        }

    @Test
    @DisplayName("a new name at the platform is not taken over, or undoes the name that the roster gave")
    fun theNameFollows() =
        room { platform ->
            register(platform)
            bindCourse(platform)

            suspend fun come(name: String?): String? {
                platform.claims = { claim("name", name) }
                launch(platform)
                return one("SELECT shown_name FROM students")
            }
            assertEquals("Ada Lovelace", come("Ada Lovelace"))
            assertEquals("Ada King", come("Ada King"))
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'lti-name'"))
            assertEquals("Ada King", come(null))
            assertEquals("Ada King", come("\u0007"))
            database.write { it.execute("UPDATE students SET name = 'Countess', shown_name = 'Countess'") }
            assertEquals("Ada King", come("Ada King"))
            database.write { it.execute("UPDATE students SET name = 'Countess', shown_name = 'Countess'") }
            assertEquals("Countess", come("Ada King"))
            database.write { it.execute("UPDATE lti_students SET told_name = NULL") }
            assertEquals("Countess", come("Ada Byron"))
            assertEquals("Ada", come("Ada"))
        }

    private suspend fun published(answer: HttpResponse): List<String> =
        Json.parseToJsonElement(answer.bodyAsText()).jsonArray.map { it.field("id") }

    @Test
    @DisplayName("the key before is gone at once or stays, its private half is kept, or another server signs with it")
    fun theKeyChanges() =
        LocalPlatform().use { platform ->
            Classroom(folder, clock = InstantSource { now }).open(grades = false) {
                register(platform)

                suspend fun read() = JWKSet.parse(client.get("/lti/jwks").bodyAsText()).keys
                val other = ToolKey(database) { now }
                val first = read().single().keyID
                assertEquals(302, sendForm("/instructor/lti/key", "").status.value)
                val (signs, before) = read()
                assertEquals(first, before.keyID)
                assertNotEquals(first, signs.keyID)
                val signed = SignedJWT.parse(other.sign(JWTClaimsSet.Builder().issuer("x").build()))
                assertEquals(signs.keyID, signed.header.keyID)
                assertTrue(signed.verify(RSASSAVerifier(signs.toRSAKey())))
                val kept = JWKSet.parse(one("SELECT CAST(value AS TEXT) FROM secrets WHERE name = 'lti-before'"))
                assertTrue(kept.keys.none { it.isPrivate }, "the private half is kept")
                assertEquals(listOf(signs.keyID, first), published(client.get(KEY) { bearer(instructor) }))
                val third = published(client.post(KEY) { bearer(instructor) })
                assertEquals(listOf(third.first(), first, signs.keyID), third)
                assertEquals("2", one("SELECT count(*) FROM audit WHERE action = 'lti-key'"))
                now += ToolKey.KEPT
                assertEquals(listOf(third.first()), read().map { it.keyID })
                val page = client.get("/instructor/lti") { header(HttpHeaders.Cookie, cookieOf(instructor)) }
                assertTrue(third.first() in page.bodyAsText())
            }
        }

    private companion object {
        const val KEY = "/api/v1/lti/key"
    }
}
