package rasterlab.grader.problem

import ch.qos.logback.classic.Level
import ch.qos.logback.classic.spi.ILoggingEvent
import io.ktor.client.request.get
import io.ktor.server.plugins.statuspages.StatusPages
import io.ktor.server.routing.get
import io.ktor.server.routing.routing
import io.ktor.server.testing.testApplication
import io.ktor.util.cio.ChannelWriteException
import io.ktor.utils.io.ClosedWriteChannelException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import rasterlab.grader.logging
import rasterlab.grader.web.ErrorPage
import java.io.IOException

class LoggingTest {
    @Test
    fun keepsQuietAboutAReaderWhoHasGone() {
        val lines = linesOf(ChannelWriteException(exception = IOException("Broken pipe")))
        assertEquals(listOf(Level.DEBUG), lines.map { it.level })
        assertEquals("GET /events: Cannot write to channel", lines.single().formattedMessage)
    }

    @Test
    fun keepsQuietAboutAReaderWhoHasGoneBeforeTheAnswerBegan() =
        assertEquals(listOf(Level.DEBUG), linesOf(ClosedWriteChannelException()).map { it.level })

    @Test
    fun tellsOfAFailureWithItsTrace() {
        val lines = linesOf(IllegalStateException("no such column"))
        assertEquals(listOf(Level.ERROR), lines.map { it.level })
        assertEquals("no such column", lines.single().throwableProxy.message)
    }

    @Test
    fun tellsOfAFileThatCannotBeRead() {
        assertEquals(listOf(Level.ERROR), linesOf(IOException("disk")).map { it.level })
    }

    private fun linesOf(failure: Exception): List<ILoggingEvent> =
        logging(Level.DEBUG) { lines ->
            testApplication {
                install(StatusPages) { showProblems(ErrorPage) }
                routing { get("/events") { throw failure } }
                client.get("/events")
            }
            lines.filter { it.loggerName == "rasterlab.grader.problem" }
        }
}
