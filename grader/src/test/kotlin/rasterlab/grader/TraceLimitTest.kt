package rasterlab.grader

import ch.qos.logback.classic.Level
import ch.qos.logback.classic.LoggerContext
import ch.qos.logback.classic.spi.ILoggingEvent
import ch.qos.logback.core.read.ListAppender
import io.ktor.http.URLDecodeException
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.slf4j.LoggerFactory
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TestTimeSource

class TraceLimitTest {
    private val clock = TestTimeSource()
    private val context = LoggerContext().apply { addTurboFilter(TraceLimit(clock).apply { most = 3 }) }
    private val events = ListAppender<ILoggingEvent>().apply { start() }
    private val log = context.getLogger("test").apply { addAppender(events) }

    @Test
    fun countsTheFailuresThatItLeavesOut() {
        repeat(1_000) { log.error("{} {} failed", "GET", it, Exception("provoked")) }
        assertEquals(listOf("GET 0 failed", "GET 1 failed", "GET 2 failed"), logged())
        clock += 61.seconds
        log.error("later", Exception())
        assertEquals(listOf("997 more failures within a minute were not logged", "later"), logged().drop(3))
    }

    @Test
    fun leavesOutNothingElse() {
        repeat(10) { log.error("no stack") }
        repeat(10) { log.info("no failure", Exception()) }
        assertEquals(20, logged().size)
        repeat(
            2,
        ) { log.log(null, "test", Level.toLocationAwareLoggerInteger(Level.WARN), "of the engine", null, Exception()) }
        assertEquals(22, logged().size)
    }

    @Test
    @DisplayName("an address that cannot be decoded is logged as a failure, at each start too")
    fun leavesOutWhatClientsGotWrong() {
        log.error("400 Bad Request: GET - /%zz", URLDecodeException("Wrong HEX escape: %zz"))
        assertEquals(emptyList<String>(), logged())
    }

    @Test
    fun holdsForAllLogs() {
        val filters = (LoggerFactory.getILoggerFactory() as LoggerContext).turboFilterList
        assertTrue(filters.any { it is TraceLimit }, "$filters")
    }

    private fun logged() = events.list.map { it.formattedMessage }
}
