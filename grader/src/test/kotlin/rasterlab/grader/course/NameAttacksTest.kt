package rasterlab.grader.course

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.MACSigner
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.PlainJWT
import com.nimbusds.jwt.SignedJWT
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.request.post
import io.ktor.client.request.setBody
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Tag
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.grader.Classroom
import rasterlab.grader.Visit
import rasterlab.grader.assertProblem
import rasterlab.grader.cookieOf
import rasterlab.grader.field
import rasterlab.grader.json
import rasterlab.grader.query
import java.nio.file.Path
import java.util.Date

/** Attacks by names and by tokens: a name is a value, and who is out stays out. */
@Tag("slow")
class NameAttacksTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest(name = "a student is called {0}")
    @ValueSource(
        strings = [
            "'); DROP TABLE students;--", "' OR '1'='1", "%", "_", "Robert\\\\' UNION SELECT token FROM tokens",
            "<script>alert(1)</script>", "😀🎓😀🎓😀🎓😀🎓😀🎓😀🎓",
        ],
    )
    fun aNameIsAValue(name: String) =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            newStudent(course)
            assertEquals(201, join(course, name).status.value)
            assertEquals(setOf("Ada", name.replace("\\\\", "\\")), names().toSet(), "names of the course")
        }

    @Test
    @DisplayName("a name that can be written in two ways is two names")
    fun aNameIsWrittenInOneWay() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            assertEquals(201, join(course, "Zoe\u0308").status.value)
            assertEquals(listOf("Zo\u00EB"), names())
        }

    @Test
    @DisplayName("two names differ by nothing but spaces, which a page does not show")
    fun spacesMakeNoOtherName() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            for (name in listOf("Ada Lovelace", " Ada   Lovelace ", "Ada\u00A0\u3000Lovelace")) {
                assertEquals(201, join(course, name).status.value)
            }
            assertEquals(List(3) { "Ada Lovelace" }, names())
            val shown = look(instructor, "/api/v1/courses/$course/students").bodyAsText()
            assertTrue("Ada Lovelace (2)" in shown && "Ada Lovelace (3)" in shown, shown)
        }

    @ParameterizedTest(name = "a name has U+{0}, which shows nothing")
    @ValueSource(
        strings = ["3164", "115F", "1160", "FFA0", "2800", "34F", "17B4", "180B", "200B", "FE0F", "E0100"],
    )
    fun whatShowsNothingIsNoName(code: String) =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            val point = String(Character.toChars(code.toInt(16)))
            for (name in listOf(point, "Ada$point")) join(course, name).assertProblem(422, "bad-name")
            assertEquals(emptyList<String>(), names())
        }

    @Test
    @DisplayName("a name of a megabyte is read to its end, or stored")
    fun aMegabyteIsNoName() =
        Classroom(folder).open(grades = false) {
            val course = newCourse()
            join(course, "x".repeat(1_000_000)).assertProblem(413, "too-large")
            join(course, "😀".repeat(81)).assertProblem(422, "bad-name")
            assertEquals(emptyList<String>(), names())
        }

    @Test
    @DisplayName("a cookie that was kept from before the sign-out opens a page")
    fun aCookieEndsWithTheSignOut() =
        Classroom(folder).open(grades = false) {
            val cookie = cookieOf(newStudent())

            suspend fun status() = client.get("/exercises/draw-dot") { header(HttpHeaders.Cookie, cookie) }.status.value
            assertEquals(200, status())
            client.post("/sign-out") {
                header(HttpHeaders.Cookie, cookie)
                header(HttpHeaders.Host, "localhost")
                header(HttpHeaders.Origin, "http://localhost")
                header(HttpHeaders.ContentType, "application/x-www-form-urlencoded")
                setBody("")
            }
            assertEquals(401, status(), "the cookie lives on")
        }

    @ParameterizedTest(name = "a token is altered: {0}")
    @ValueSource(
        strings = [
            "upper case", "cut", "longer", "unsigned JWT", "JWT of another role", "JWT of another key", "expired JWT",
        ],
    )
    fun anAlteredTokenOpensNothing(how: String) =
        Classroom(folder).open(grades = false) {
            val token = newStudent()
            val altered =
                when (how) {
                    "upper case" -> token.uppercase()
                    "cut" -> token.dropLast(1)
                    "longer" -> token + "a"
                    "unsigned JWT" -> PlainJWT(claims(token).build()).serialize()
                    "JWT of another role" -> signed(claims(token).claim("role", "instructor"), token.repeat(2))
                    "JWT of another key" -> signed(claims(token), "a key of the sender's own choice, long enough")
                    else -> signed(claims(token).expirationTime(Date(0)), token.repeat(2))
                }
            look(altered, "/api/v1/exercises").assertProblem(401, "not-signed-in")
        }

    private fun claims(token: String) = JWTClaimsSet.Builder().subject(token).claim("role", "student")

    private fun signed(
        claims: JWTClaimsSet.Builder,
        key: String,
    ): String =
        SignedJWT(JWSHeader(JWSAlgorithm.HS256), claims.build())
            .apply { sign(MACSigner(key.encodeToByteArray())) }
            .serialize()

    private suspend fun Visit.join(
        course: String,
        name: String,
    ) = client.post("/api/v1/join") { json("""{"course":"$course","name":"$name"}""") }

    private suspend fun Visit.names(): List<String> {
        val course = query(folder.resolve("test.db"), "SELECT id FROM courses")
        val students = look(instructor, "/api/v1/courses/$course/students").bodyAsText()
        return Json.parseToJsonElement(students).jsonArray.map { it.field("name") }
    }
}
