package rasterlab.grader.lti

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.MACSigner
import com.nimbusds.jose.jwk.RSAKey
import com.nimbusds.jwt.PlainJWT
import com.nimbusds.jwt.SignedJWT
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.HttpResponse
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import io.ktor.http.Parameters
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
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
import rasterlab.grader.course.Staff
import rasterlab.grader.one
import rasterlab.grader.postgres.OnPostgres
import rasterlab.grader.sendForm
import java.nio.file.Path
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.Date

/** Lets people in whom a learning platform sends that runs on this machine, and nobody where it lies. */
@Tag("slow")
open class LaunchTest {
    @TempDir
    lateinit var folder: Path

    private var now = Instant.now()

    private fun room(test: suspend Visit.(LocalPlatform) -> Unit) =
        LocalPlatform().use { platform ->
            Classroom(
                folder,
                settings = ServerSettings(entriesPerMinute = 100_000),
                clock = InstantSource { now },
            ).open(grades = false) { test(platform) }
        }

    @Test
    @DisplayName("a student is not let in to the link's exercise, or becomes another one the next time")
    fun aStudentComesIn() =
        room { platform ->
            register(platform)
            bindCourse(platform)
            repeat(2) {
                val arrived = launch(platform)
                assertEquals("0; url=/exercises/draw-dot", arrived.headers["Refresh"], arrived.bodyAsText())
                assertTrue("Ada Lovelace · Graphics" in arrived.bodyAsText())
                val page = client.get("/exercises/draw-dot") { header(HttpHeaders.Cookie, "${arrived.session()}") }
                assertEquals(200, page.status.value)
            }
            platform.person = "kay-there"
            platform.claims = { claim("name", null).claim("given_name", "Kay").claim("family_name", "\u0007") }
            launch(platform)
            assertEquals(
                "1 Ada Lovelace, 2 Student",
                one(
                    "SELECT string_agg(number || ' ' || name, ', ') FROM (SELECT * FROM students ORDER BY number) AS s",
                ),
            )
        }

    @Test
    @DisplayName("a student of the roster gets a second account, or somebody else's")
    fun theRosterIsFound() =
        room { platform ->
            register(platform)
            bindCourse(platform)
            val course = one("SELECT id FROM courses")
            client.post("/api/v1/courses/$course/roster") {
                bearer(instructor)
                header(HttpHeaders.ContentType, "text/csv")
                setBody("Name,ID number\nAda,4711\nKay,4712\n")
            }
            platform.claims = { claim("${LocalPlatform.LTI}lis", mapOf("person_sourcedid" to "4711")) }
            launch(platform)
            assertEquals("Ada", one("SELECT name FROM students JOIN lti_students ON student_id = id"))
            platform.person = "eve-there"
            launch(platform)
            assertEquals(
                "Ada Lovelace",
                one("SELECT name FROM students JOIN lti_students ON student_id = id WHERE subject = 'eve-there'"),
            )
        }

    @Test
    @DisplayName("an instructor of the platform becomes one here unasked, or is asked again each time")
    fun staffSayOnceWhoTheyAre() =
        room { platform ->
            register(platform)
            platform.roles = listOf("${LocalPlatform.MEMBERSHIP}#Instructor")
            val asked = launch(platform)
            assertTrue("Who are you here?" in asked.bodyAsText(), asked.bodyAsText())
            val wrong = reply(asked, "/lti/staff", "token" to "nobody's")
            assertEquals(422, wrong.status.value)
            assertEquals(null, wrong.session())
            val which = reply(wrong, "/lti/staff", "token" to instructor)
            val unnamed = reply(which, "/lti/course", "course" to "", "name" to " ")
            assertEquals(422, unnamed.status.value)
            val arrived = reply(unnamed, "/lti/course", "course" to "", "name" to "Graphics")
            assertEquals("0; url=/exercises/draw-dot", arrived.headers["Refresh"])
            assertEquals("0; url=/exercises/draw-dot", launch(platform).headers["Refresh"])
            assertEquals("1", one("SELECT count(*) FROM instructors"))
            assertEquals("1", one("SELECT count(*) FROM courses"))
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'lti-staff'"))
            assertEquals("1", one("SELECT count(*) FROM audit WHERE action = 'lti-bind'"))
            assertRefused(400, reply(which, "/lti/course", "course" to "", "name" to "Again"))
            database.write { it.execute("UPDATE instructors SET revoked_at = '2026-01-01T00:00:00Z'") }
            assertRefused(403, launch(platform))
        }

    @Test
    @DisplayName("a course is joined by a student or an assistant, or an assistant becomes an instructor")
    fun onlyInstructorsJoinCourses() =
        room { platform ->
            register(platform, makesStaff = true)
            assertRefused(403, launch(platform))
            platform.person = "alan-there"
            platform.roles =
                listOf("#Instructor", "/Instructor#TeachingAssistant").map { "${LocalPlatform.MEMBERSHIP}$it" }
            assertRefused(403, launch(platform))
            assertEquals("assistant", one("SELECT role FROM instructors WHERE name = 'Ada Lovelace'"))
            platform.person = "grace-there"
            platform.roles = listOf("${LocalPlatform.MEMBERSHIP}#Instructor")
            val which = launch(platform)
            assertTrue("Which course is it?" in which.bodyAsText(), which.bodyAsText())
            assertEquals("3", "${Staff(database, InstantSource.system()).all().size}")
            platform.roles = listOf("http://purl.imsglobal.org/vocab/lis/v2/institution/person#Administrator")
            assertRefused(403, launch(platform))
        }

    @Test
    @DisplayName("a frame gets a session, other sites may frame our pages, or the window opens twice")
    fun aFrameOpensAWindow() =
        room { platform ->
            register(platform)
            bindCourse(platform)
            platform.claims = {
                claim("${LocalPlatform.LTI}launch_presentation", mapOf("return_url" to "https://school.example/x"))
            }
            val framed = launch(platform, frame = true)
            assertEquals(null, framed.session())
            assertEquals(null, framed.headers["Refresh"])
            val policy =
                framed.headers
                    .getAll("Content-Security-Policy")
                    .orEmpty()
                    .single()
            assertTrue("frame-ancestors ${platform.issuer} https://school.example" in policy, policy)
            assertTrue("target=\"_blank\"" in framed.bodyAsText())
            val opened = reply(framed, "/lti/open")
            assertTrue(opened.session() != null, opened.bodyAsText())
            assertEquals("0; url=/exercises/draw-dot", opened.headers["Refresh"])
            assertRefused(400, reply(framed, "/lti/open"))
            val other =
                client
                    .get("/")
                    .headers
                    .getAll("Content-Security-Policy")
                    .orEmpty()
                    .single()
            assertTrue("frame-ancestors 'none'" in other, other)
        }

    @ParameterizedTest(name = "somebody comes in by {argumentSetName}")
    @MethodSource("lies")
    fun aLieIsRefused(
        status: Int,
        words: String,
        lie: LocalPlatform.() -> Unit,
    ) = room { platform ->
        register(platform)
        bindCourse(platform)
        val before = one("SELECT count(*) FROM sessions")
        platform.lie()
        val refused = launch(platform)
        assertRefused(status, refused)
        assertTrue(words in refused.bodyAsText(), refused.bodyAsText())
        assertEquals(before, one("SELECT count(*) FROM sessions"))
        assertEquals("0", one("SELECT count(*) FROM students"))
    }

    @Test
    @DisplayName("another browser's state, one that was used or is too old, or the message of another launch is taken")
    fun anAnswerFitsOneBeginning() =
        room { platform ->
            register(platform)
            bindCourse(platform)
            val first = beginLaunch(platform).begun()
            val other = beginLaunch(platform).begun()
            assertRefused(400, endLaunch(platform.answer(first.place), other.cookie))
            val foreign = other.cookie.replace(Regex("^[^=]+"), first.cookie.substringBefore('='))
            val second = beginLaunch(platform).begun()
            val stolen = foreign.replace(Regex("^[^=]+"), second.cookie.substringBefore('='))
            assertRefused(400, endLaunch(platform.answer(second.place), stolen))
            val third = beginLaunch(platform).begun()
            val cookieless = endLaunch(platform.answer(third.place), cookie = null)
            assertRefused(400, cookieless)
            assertTrue("kept no cookie" in cookieless.bodyAsText())
            val fourth = beginLaunch(platform).begun()
            val used = platform.answer(fourth.place)
            assertEquals(200, endLaunch(used, fourth.cookie).status.value)
            assertRefused(400, endLaunch(used, fourth.cookie))
            val fifth = beginLaunch(platform).begun()
            val fresh = platform.answer(fifth.place)
            val replayed =
                Parameters.build {
                    append("state", "${fresh["state"]}")
                    append("id_token", "${used["id_token"]}")
                }
            assertRefused(403, endLaunch(replayed, fifth.cookie))
            val sixth = beginLaunch(platform).begun()
            val late = platform.answer(sixth.place)
            now += Duration.ofMinutes(10)
            assertRefused(400, endLaunch(late, sixth.cookie))
        }

    @Test
    @DisplayName("a platform that nobody registered begins a launch, or one that is known cannot")
    fun onlyRegisteredPlatformsBegin() =
        room { platform ->
            assertRefused(400, beginLaunch(platform))
            val made = register(platform)
            assertRefused(400, client.get("/lti/login?iss=${platform.issuer}"))
            assertRefused(400, client.get("/lti/login?iss=${platform.issuer}&login_hint=1&client_id=other"))
            assertRefused(400, client.get("/lti/login?iss=${platform.issuer}&login_hint=1&lti_deployment_id=2"))
            assertEquals(302, client.get("/lti/login?iss=${platform.issuer}&login_hint=1").status.value)
            Platforms(database, InstantSource.system()).remove(made.id, "test")
            assertRefused(400, beginLaunch(platform))
        }

    @Test
    @DisplayName("a new key of the platform keeps everybody out, or one that is away is answered with an error of ours")
    fun keysChange() =
        room { platform ->
            register(platform)
            bindCourse(platform)
            platform.keys = LocalPlatform.key()
            assertEquals(200, launch(platform).status.value)
            val other = LocalPlatform()
            register(other)
            val begun = beginLaunch(other).begun()
            val answer = other.answer(begun.place)
            other.away(gone = true)
            assertRefused(503, endLaunch(answer, begun.cookie))
            other.close()
        }

    @Test
    @DisplayName("a launch that began at one server cannot end at another, or these have keys of their own")
    fun serversShareEverything() =
        LocalPlatform().use { platform ->
            var begun: BegunVisit? = null
            var keys = ""
            Classroom(folder).open(grades = false) {
                register(platform)
                bindCourse(platform)
                begun = beginLaunch(platform).begun()
                keys = client.get("/lti/jwks").bodyAsText()
            }
            Classroom(folder).open(grades = false) {
                val first = checkNotNull(begun)
                assertEquals(200, endLaunch(platform.answer(first.place), first.cookie).status.value)
                assertEquals(keys, client.get("/lti/jwks").bodyAsText())
                assertTrue("\"d\"" !in keys && "\"p\"" !in keys, "the private half is published")
            }
        }

    @Test
    @DisplayName("a platform is registered twice or with an address that others can read, or its removal leaves a rest")
    fun registrationsAreChecked() =
        room { platform ->
            suspend fun add(change: (String) -> String = { it }) =
                sendForm(
                    "/instructor/lti",
                    change(
                        "name=Moodle&issuer=https://m.example&client-id=c&deployment=1&keys-url=https://m.example/k" +
                            "&token-url=https://m.example/t&login-url=https://m.example/l",
                    ),
                )
            assertEquals(422, add { it.replace("https://m.example/k", "http://m.example/k") }.status.value)
            assertEquals(422, add { it.replace("client-id=c", "client-id=") }.status.value)
            assertEquals(302, add().status.value)
            val again = add()
            assertEquals(422, again.status.value)
            assertTrue("already" in again.bodyAsText() && "https://m.example/t" in again.bodyAsText())
            assertEquals("0", one("SELECT makes_staff FROM lti_platforms"))
            val made = register(platform)
            bindCourse(platform)
            launch(platform)
            assertEquals(302, sendForm("/instructor/lti/${made.id}/remove", "").status.value)
            for (table in listOf("lti_contexts", "lti_students", "lti_staff", "lti_links")) {
                assertEquals("0", one("SELECT count(*) FROM $table"), table)
            }
            assertEquals("1", one("SELECT count(*) FROM students"))
            assertNotEquals("0", one("SELECT count(*) FROM audit WHERE action = 'lti-remove'"))
        }

    private suspend fun assertRefused(
        status: Int,
        answer: HttpResponse,
    ) {
        assertEquals(status, answer.status.value, answer.bodyAsText())
        assertTrue("You are not signed in" in answer.bodyAsText(), answer.bodyAsText())
        assertEquals(null, answer.session())
    }

    private companion object {
        private fun lie(
            name: String,
            status: Int = 403,
            words: String = "not certainly the word of the platform",
            lie: LocalPlatform.() -> Unit,
        ): Arguments = argumentSet(name, status, words, lie)

        private fun claim(
            name: String,
            value: Any?,
        ): LocalPlatform.() -> Unit = { claims = { claim("${LocalPlatform.LTI}$name", value) } }

        @JvmStatic
        fun lies(): List<Arguments> =
            listOf(
                lie("the nonce of another launch") { claims = { claim("nonce", "x") } },
                lie("a message without a nonce") { claims = { claim("nonce", null) } },
                lie("a message for another tool") { claims = { audience("another") } },
                lie("a message for several that was made for none") {
                    claims = { audience(listOf(LocalPlatform.CLIENT, "b")) }
                },
                lie("a message that was made for another") { claims = { claim("azp", "another") } },
                lie("the message of another platform") { claims = { issuer("https://evil.example") } },
                lie("an expired message", words = "too old") {
                    claims = { expirationTime(Date(System.currentTimeMillis() - 120_000)) }
                },
                lie("a message without an end") { claims = { expirationTime(null) } },
                lie("a message of tomorrow") { claims = { issueTime(Date(System.currentTimeMillis() + 86_400_000)) } },
                lie("a message that nobody signed") { token = { PlainJWT(it) } },
                lie("a key that the platform does not publish") {
                    val other = LocalPlatform.key()
                    token = { LocalPlatform.signed(other, it) }
                },
                lie("a key of the same name") {
                    val own = keys
                    val other = LocalPlatform.key()
                    token = { LocalPlatform.signed(RSAKey.Builder(other).keyID(own.keyID).build(), it) }
                },
                lie("a message that the public key signed as a secret") {
                    val public = keys.toRSAPublicKey().encoded
                    token = {
                        SignedJWT(JWSHeader.Builder(JWSAlgorithm.HS256).keyID(keys.keyID).build(), it)
                            .apply { sign(MACSigner(public)) }
                    }
                },
                lie("a place that is not registered", words = "deployment ID", lie = claim("deployment_id", "2")),
                lie("no place", words = "deployment ID", lie = claim("deployment_id", null)),
                lie("another version", 400, "LTI 1.3", claim("version", "1.1")),
                lie("another message", 400, "LTI 1.3", claim("message_type", "LtiSubmissionReviewRequest")),
                lie("a message of another shape", 400, "LTI 1.3", claim("roles", "Learner")),
                lie("no course", 400, "LTI 1.3", claim("context", null)),
                lie("no link", 400, "LTI 1.3", claim("resource_link", mapOf("title" to "x"))),
                lie("no role", words = "no role in its course", lie = claim("roles", emptyList<String>())),
            )
    }
}

@OnPostgres
class LaunchOnPostgresTest : LaunchTest()
