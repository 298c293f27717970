package rasterlab.grader.institution

import rasterlab.grader.storage.Secrets
import java.time.Duration
import java.time.Instant
import java.time.InstantSource

/**
 * Keeps values for a while, each for whoever has its secret key, and gives each out once. Where there are too many, the
 * oldest goes.
 */
internal class OnceOnly<T : Any>(
    private val clock: InstantSource,
    private val most: Int = MOST,
) {
    private class Kept<T>(
        val value: T,
        val until: Instant,
    )

    private val kept = LinkedHashMap<String, Kept<T>>()

    /** Keeps a value under the key that it returns. */
    @Synchronized
    fun keep(value: T): String {
        val now = clock.instant()
        kept.values.removeIf { it.until <= now }
        if (kept.size >= most) kept.remove(kept.keys.first())
        val key = Secrets.newToken()
        kept[key] = Kept(value, now + LIFE)
        return key
    }

    /** The value of this key, which is forgotten with that; null where there is none, or it is too old. */
    @Synchronized
    fun take(key: String): T? = kept.remove(key)?.takeIf { clock.instant() < it.until }?.value

    companion object {
        /** How long people have to sign in at their institution. */
        val LIFE: Duration = Duration.ofMinutes(10)

        private const val MOST = 10_000
    }
}
