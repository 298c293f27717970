package rasterlab.grader.web

import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.grader.Classroom
import rasterlab.grader.course.Accounts
import java.nio.file.Path
import java.time.InstantSource

/** What shuts the students' methods in is told to those who answer for the server. */
class IsolationTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @DisplayName("who watches the server is not told what is missing of its isolation")
    fun readinessTellsTheIsolation() =
        Classroom(folder).open(grades = false) {
            val answer = client.get("/readyz")
            assertEquals(200, answer.status.value)
            assertEquals(
                listOf(
                    "ready",
                    "isolation: process limits only",
                    "missing: bubblewrap (bwrap is not on the PATH)",
                    "exam: no",
                ),
                answer.bodyAsText().trim().lines(),
            )
            val russian = client.get("/readyz?lang=ru").bodyAsText()
            assertTrue("missing: bubblewrap (bwrap не найден в PATH)" in russian, russian)
        }

    @Test
    @DisplayName("the instructor is not told on the page what shuts the students' methods in")
    fun theCourseDeskTellsTheIsolation() =
        Classroom(folder).open(grades = false) {
            val accounts = Accounts(database, InstantSource.system())
            val cookie = "rasterlab=${accounts.open(checkNotNull(accounts.holder(instructor)))}"
            for ((language, words) in listOf("en" to "a determined attacker", "ru" to "упорного злоумышленника")) {
                val page = client.get("/instructor?lang=$language") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
                assertTrue(words in page, page)
            }
        }
}
