package rasterlab.grader

import ch.qos.logback.classic.Level
import ch.qos.logback.classic.Logger
import ch.qos.logback.classic.turbo.TurboFilter
import ch.qos.logback.core.spi.FilterReply
import io.ktor.http.URLDecodeException
import org.slf4j.Marker
import kotlin.time.Duration.Companion.minutes
import kotlin.time.TimeMark
import kotlin.time.TimeSource

/**
 * Lets [most] failures a minute into the logs, each with its stack; the next minute's first tells how many
 * were left out. Whoever can provoke a failure could otherwise fill the disk by provoking it again.
 *
 * An address that cannot be decoded is no failure of ours, and is not logged: it is answered with 400.
 *
 * Set in logback.xml, so that it holds for the engine and the database as well.
 */
class TraceLimit(
    private val clock: TimeSource,
) : TurboFilter() {
    @Suppress("unused") // logback makes it so
    constructor() : this(TimeSource.Monotonic)

    /** Failures a minute. */
    var most = 60
    private var minute: TimeMark? = null
    private var met = 0

    override fun decide(
        marker: Marker?,
        logger: Logger,
        level: Level,
        format: String?,
        params: Array<out Any?>?,
        failure: Throwable?,
    ): FilterReply {
        val stack = failure ?: params?.lastOrNull() as? Throwable
        if (stack == null || !level.isGreaterOrEqual(Level.WARN)) return FilterReply.NEUTRAL
        if (stack is URLDecodeException) return FilterReply.DENY
        val leftOut = count() ?: return FilterReply.DENY
        if (leftOut > 0) logger.warn("{} more failures within a minute were not logged", leftOut)
        return FilterReply.NEUTRAL
    }

    /** How many were left out before, where this one may be logged, or null. */
    @Synchronized
    private fun count(): Int? {
        var leftOut = 0
        if (minute?.let { it.elapsedNow() < 1.minutes } != true) {
            leftOut = maxOf(0, met - most)
            minute = clock.markNow()
            met = 0
        }
        return if (met++ < most) leftOut else null
    }
}
