package rasterlab.grader.submission

import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/**
 * A clock moved by nothing but the passing of time: it begins with what the wall clock shows then,
 * and does not follow when that one is set. Whatever is due after a while is told by it; what
 * people read is told by the wall clock. Where several processes share a database, each follows the database's clock.
 *
 * @param nanos a reading that only grows
 */
class SteadyClock(
    private val wall: InstantSource,
    private val nanos: () -> Long = System::nanoTime,
) : InstantSource {
    private val first = wall.instant()
    private val firstNanos = nanos()

    @Volatile
    private var moved = Duration.ZERO

    override fun instant(): Instant = passed() + moved

    /** Shows what the clock shows that all follow, from now on; returns how far that sets this one ahead. */
    fun follow(common: Instant): Duration {
        val step = Duration.between(instant(), common)
        moved += step
        return step
    }

    /** How far the wall clock has been set ahead since the beginning; negative where it has been set back. */
    fun wallAhead(): Duration = Duration.between(passed(), wall.instant())

    private fun passed(): Instant = first.plusNanos(nanos() - firstNanos)
}
