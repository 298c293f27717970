package rasterlab.grader.lti

import com.nimbusds.jose.crypto.RSASSAVerifier
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.SignedJWT
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.one
import java.nio.file.Path

/** Links to exercises are chosen here and arrive at the platform, which knows them to be this server's by its key. */
@Tag("slow")
class DeepLinksTest {
    @TempDir
    lateinit var folder: Path

    private val settings =
        mapOf(
            "deep_link_return_url" to "https://moodle.example/back?id=1",
            "accept_types" to listOf("link", "ltiResourceLink"),
            "accept_multiple" to true,
            "accept_lineitem" to true,
            "data" to "kept as it is",
        )

    private fun room(test: suspend Visit.(LocalPlatform) -> Unit) =
        LocalPlatform().use { platform ->
            Classroom(folder).open(grades = false) {
                register(platform)
                bindCourse(platform)
                platform.person = "grace-there"
                platform.roles = listOf("${LocalPlatform.MEMBERSHIP}#Instructor")
                asks(platform, settings)
                test(platform)
            }
        }

    private fun asks(
        platform: LocalPlatform,
        settings: Map<String, Any>,
    ) {
        platform.claims = {
            claim("${LocalPlatform.LTI}message_type", "LtiDeepLinkingRequest")
            claim("${LocalPlatform.LTI}resource_link", null)
            claim("${LocalPlatform.DEEP_LINKING}deep_linking_settings", settings)
        }
    }

    @Test
    @DisplayName("the platform cannot trust the answer, or it names no exercise, no points or another place")
    fun theAnswerArrives() =
        room { platform ->
            val page = launch(platform, frame = true)
            assertTrue("type=\"checkbox\" name=\"exercise\"" in page.bodyAsText(), page.bodyAsText())
            val answer = reply(page, "/lti/links", "exercise" to "draw-dot")
            val policy =
                answer.headers
                    .getAll("Content-Security-Policy")
                    .orEmpty()
                    .single()
            assertTrue("form-action 'self' ${platform.issuer} https://moodle.example;" in policy, policy)
            val claims = verified(platform, answer)
            assertEquals(LocalPlatform.CLIENT to listOf(platform.issuer), claims.issuer to claims.audience)
            assertEquals("LtiDeepLinkingResponse", claims.getClaim("${LocalPlatform.LTI}message_type"))
            assertEquals("1.3.0", claims.getClaim("${LocalPlatform.LTI}version"))
            assertEquals("1", claims.getClaim("${LocalPlatform.LTI}deployment_id"))
            assertEquals("kept as it is", claims.getClaim("${LocalPlatform.DEEP_LINKING}data"))
            assertNotEquals(null, claims.getClaim("nonce"))
            assertTrue(claims.expirationTime > claims.issueTime)
            assertEquals(
                listOf(
                    mapOf(
                        "type" to "ltiResourceLink",
                        "title" to "Draw a dot",
                        "url" to "http://localhost/lti/launch",
                        "custom" to mapOf("exercise" to "draw-dot"),
                        "lineItem" to mapOf("scoreMaximum" to 10L, "label" to "Draw a dot", "resourceId" to "draw-dot"),
                    ),
                ),
                claims.getClaim("${LocalPlatform.DEEP_LINKING}content_items"),
            )
        }

    @Test
    @DisplayName("a platform that takes one link gets several, or one that takes no points gets them")
    fun onlyWhatThePlatformTakes() =
        room { platform ->
            asks(platform, settings + mapOf("accept_multiple" to false, "accept_lineitem" to false) - "data")
            val page = launch(platform)
            assertTrue("type=\"radio\" name=\"exercise\"" in page.bodyAsText(), page.bodyAsText())
            val none = reply(page, "/lti/links")
            assertEquals(422, none.status.value)
            val claims = verified(platform, reply(none, "/lti/links", "exercise" to "draw-dot"))
            val item = (claims.getClaim("${LocalPlatform.DEEP_LINKING}content_items") as List<*>).single() as Map<*, *>
            assertEquals(setOf("type", "title", "url", "custom"), item.keys)
            assertEquals(null, claims.getClaim("${LocalPlatform.DEEP_LINKING}data"))
        }

    @Test
    @DisplayName("a student chooses links, or they are sent where anybody reads them, or to a platform that takes none")
    fun whatIsNoWishIsRefused() =
        room { platform ->
            platform.roles = listOf("${LocalPlatform.MEMBERSHIP}#Learner")
            assertEquals(403, launch(platform).status.value)
            platform.roles = listOf("${LocalPlatform.MEMBERSHIP}#Instructor")
            asks(platform, settings + ("deep_link_return_url" to "http://moodle.example/back"))
            assertEquals(400, launch(platform).status.value)
            asks(platform, settings + ("accept_types" to listOf("file")))
            assertEquals(400, launch(platform).status.value)
        }

    @Test
    @DisplayName("staff of a single course link another course's exercises, or are let into that course")
    fun staffOfAnotherCourseAreRefused() =
        room { platform ->
            database.write {
                it.execute(
                    "INSERT INTO courses (id, name, code, created_at) VALUES ('o', 'O', 'O', '2027')",
                )
            }
            for (role in listOf("instructor", "assistant")) {
                database.write { it.execute("UPDATE instructors SET role = '$role', course_id = 'o'") }
                asks(platform, settings)
                val refused = launch(platform)
                assertEquals(403, refused.status.value, refused.bodyAsText())
                assertTrue("You teach another course here" in refused.bodyAsText(), refused.bodyAsText())
                platform.claims = {}
                assertEquals(403, launch(platform).status.value)
            }
            val own = one("SELECT course_id FROM lti_contexts")
            database.write { it.execute("UPDATE instructors SET role = 'instructor', course_id = '$own'") }
            asks(platform, settings)
            assertTrue("name=\"exercise\"" in launch(platform).bodyAsText())
        }

    @Test
    @DisplayName("staff who got another course meanwhile still answer with links of the one before")
    fun theQuestionIsNoTicket() =
        room { platform ->
            val page = launch(platform, frame = true)
            database.write {
                it.execute(
                    "INSERT INTO courses (id, name, code, created_at) VALUES ('o', 'O', 'O', '2027')",
                )
            }
            database.write { it.execute("UPDATE instructors SET course_id = 'o'") }
            val answer = reply(page, "/lti/links", "exercise" to "draw-dot")
            assertEquals(403, answer.status.value, answer.bodyAsText())
            assertTrue("name=\"JWT\"" !in answer.bodyAsText())
        }

    private suspend fun verified(
        platform: LocalPlatform,
        answer: HttpResponse,
    ): JWTClaimsSet {
        val page = answer.bodyAsText()
        assertTrue("action=\"https://moodle.example/back?id=1\"" in page && "data-send" in page, page)
        val token = checkNotNull(Regex("name=\"JWT\" value=\"([^\"]+)\"").find(page)) { page }.groupValues[1]
        val signed = SignedJWT.parse(token)
        val key = platform.toolKeys().getKeyByKeyId(signed.header.keyID).toRSAKey()
        assertTrue(signed.verify(RSASSAVerifier(key)), "the signature is not this server's")
        return signed.jwtClaimsSet
    }
}
