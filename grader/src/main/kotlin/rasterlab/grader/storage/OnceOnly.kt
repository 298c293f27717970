package rasterlab.grader.storage

import java.time.Duration
import java.time.InstantSource
import kotlin.jvm.optionals.getOrNull

/**
 * Keeps texts for a while, each for whoever has its secret key, and gives each out once, by whichever process it is asked
 * for. Where there are too many of a kind, the oldest go.
 *
 * @param kind whose texts they are; those of another kind are not given out
 */
class OnceOnly(
    private val database: Database,
    private val clock: InstantSource,
    private val kind: String,
    private val most: Int = MOST,
) {
    /** Keeps a text under the key that it returns. */
    fun keep(value: String): String {
        val key = Secrets.newToken()
        val now = clock.instant()
        database.write { handle ->
            handle.createUpdate("DELETE FROM once_only WHERE expires_at <= :now").bind("now", now.text()).execute()
            handle
                .createUpdate(
                    """INSERT INTO once_only (key_hash, kind, value, expires_at)
                       VALUES (:hash, :kind, :value, :expires)""",
                ).bind("hash", Secrets.hash(key))
                .bind("kind", kind)
                .bind("value", value)
                .bind("expires", (now + LIFE).text())
                .execute()
            handle
                .createUpdate(
                    """DELETE FROM once_only WHERE kind = :kind AND expires_at < (SELECT expires_at FROM once_only
                       WHERE kind = :kind ORDER BY expires_at DESC LIMIT 1 OFFSET :last)""",
                ).bind("kind", kind)
                .bind("last", most - 1)
                .execute()
        }
        return key
    }

    /** The text of this key, which is forgotten with that; null where there is none, or it is too old. */
    fun take(key: String): String? =
        database.write { handle ->
            val hash = Secrets.hash(key)
            val found =
                handle
                    .createQuery(
                        "SELECT value FROM once_only WHERE key_hash = :hash AND kind = :kind AND expires_at > :now",
                    ).bind("hash", hash)
                    .bind("kind", kind)
                    .bind("now", clock.instant().text())
                    .mapTo(String::class.java)
                    .findOne()
                    .getOrNull()
            if (found != null) {
                handle.createUpdate("DELETE FROM once_only WHERE key_hash = :hash").bind("hash", hash).execute()
            }
            found
        }

    companion object {
        /** How long people have to come back. */
        val LIFE: Duration = Duration.ofMinutes(10)

        private const val MOST = 10_000
    }
}
