package rasterlab.grader.web

import ch.qos.logback.classic.Logger
import ch.qos.logback.classic.spi.ILoggingEvent
import ch.qos.logback.core.read.ListAppender
import io.ktor.client.request.get
import io.ktor.client.request.header
import io.ktor.client.statement.bodyAsText
import io.ktor.http.HttpHeaders
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.slf4j.LoggerFactory
import rasterlab.exercises.runner.Isolation
import rasterlab.exercises.score.Message
import rasterlab.grader.Classroom
import rasterlab.grader.CommandWords
import rasterlab.grader.course.Accounts
import rasterlab.grader.isolationLines
import java.nio.file.Path
import java.time.InstantSource

/** The isolation of the students' methods is told to those who answer for the server. */
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
            val described = client.get("/openapi.json").bodyAsText()
            assertTrue("keys are English in both languages" in described, "who reads the lines is not told so")
            val russian = client.get("/readyz?lang=ru").bodyAsText()
            assertTrue("missing: bubblewrap (bwrap не найден в PATH)" in russian, russian)
        }

    @Test
    @DisplayName("the isolation of the start is told when it is another already")
    fun tellsTheIsolationAsItIsNow() {
        var now = Classroom.ISOLATION
        Classroom(folder, isolation = { now }).open(grades = false) {
            val later = Message.of("missing.image-making")
            now = Isolation(now.name(), Message.of("isolation.image-making"), listOf(later), false)
            assertTrue("(it is being made)" in client.get("/readyz").bodyAsText())
            val accounts = Accounts(database, InstantSource.system())
            val cookie = "rasterlab=${accounts.open(checkNotNull(accounts.holder(instructor)))}"
            val page = client.get("/instructor") { header(HttpHeaders.Cookie, cookie) }.bodyAsText()
            assertTrue("until the image of its needed modules is made" in page, page)
        }
    }

    @Test
    @DisplayName("one long line tells at the start what is missing")
    fun theStartTellsEachMissingLayerInALineOfItsOwn() {
        val lines = isolationLines(CommandWords.asked("--lang", "ru"), Classroom.ISOLATION)
        assertEquals("изоляции не хватает: bubblewrap (bwrap не найден в PATH)", lines.last())
        assertEquals(2, lines.size)
    }

    @Test
    @DisplayName("the log tells the address of the engine behind the door")
    fun theLogTellsNoInnerPort() {
        val seen = ListAppender<ILoggingEvent>().apply { start() }
        val root = LoggerFactory.getLogger(Logger.ROOT_LOGGER_NAME) as Logger
        root.addAppender(seen)
        try {
            Classroom(folder).listen { }
        } finally {
            root.detachAppender(seen)
        }
        val told = seen.list.map { it.formattedMessage }.filter { "Responding at" in it }
        assertEquals(emptyList<String>(), told)
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
