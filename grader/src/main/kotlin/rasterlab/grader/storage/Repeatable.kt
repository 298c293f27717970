package rasterlab.grader.storage

import org.jdbi.v3.core.Handle
import rasterlab.grader.problem.Rejection
import java.time.Instant
import kotlin.jvm.optionals.getOrNull

/**
 * A request that its sender may repeat without it being done twice.
 *
 * @param owner whose keys it stands among
 * @param key what the sender called it, or null if it may not be repeated
 * @param fingerprint of everything that the request asks for
 */
class Repeatable(
    private val owner: String,
    private val key: String?,
    private val fingerprint: String,
) {
    /** The submission that an earlier request of this key made, or null if this is the first. */
    fun made(handle: Handle): String? {
        if (key == null) return null
        val earlier =
            handle
                .createQuery("SELECT request_hash, made FROM idempotency_keys WHERE owner = :owner AND key_hash = :key")
                .bind("owner", owner)
                .bind("key", Secrets.hash(key))
                .map { row, _ -> row.getString("request_hash") to row.getString("made") }
                .findOne()
                .getOrNull() ?: return null
        if (earlier.first != Secrets.hash(fingerprint)) throw Rejection.KeyReused()
        return earlier.second
    }

    /** Remembers in the transaction of [handle] that this request made [id]. */
    fun remember(
        handle: Handle,
        id: String,
        now: Instant,
    ) {
        if (key == null) return
        handle
            .createUpdate(
                """INSERT INTO idempotency_keys (owner, key_hash, request_hash, made, created_at)
                   VALUES (:owner, :key, :request, :made, :now)""",
            ).bind("owner", owner)
            .bind("key", Secrets.hash(key))
            .bind("request", Secrets.hash(fingerprint))
            .bind("made", id)
            .bind("now", now.text())
            .execute()
    }
}
