package rasterlab.grader.lti

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.RSASSASigner
import com.nimbusds.jose.jwk.JWK
import com.nimbusds.jose.jwk.JWKSet
import com.nimbusds.jose.jwk.KeyUse
import com.nimbusds.jose.jwk.RSAKey
import com.nimbusds.jose.jwk.gen.RSAKeyGenerator
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.SignedJWT
import org.jdbi.v3.core.Handle
import rasterlab.grader.course.AuditNote
import rasterlab.grader.storage.Database
import rasterlab.grader.storage.Repeatable
import java.time.Duration
import java.time.Instant
import java.time.InstantSource
import java.util.Date
import kotlin.jvm.optionals.getOrNull

/**
 * A key that platforms read here.
 *
 * @param id names it in what it signs
 * @param until when it is published no longer; null for the one that signs now
 */
data class PublishedKey(
    val id: String,
    val until: Instant?,
)

/**
 * This server's own pair of keys, one for all servers that share the database; made where it is first asked for. It is read
 * anew each time, since another server or a command may have changed it.
 */
class ToolKey(
    private val database: Database,
    private val clock: InstantSource,
) {
    internal val pair: RSAKey get() = database.read(::stored) ?: database.write { stored(it) ?: fresh(it) }

    /** The public halves, as platforms read them: of the key that signs now, and of those whose messages may still hold. */
    fun publicSet(): String = JWKSet(read().map { it as JWK }).toString()

    /** Tells the keys that platforms read, the one that signs first. */
    fun published(): List<PublishedKey> = read().map { PublishedKey(it.keyID, it.expirationTime?.toInstant()) }

    /** Reads all public halves, the one that signs first. */
    private fun read(): List<RSAKey> =
        database.read(::both)
            ?: database.write { handle -> both(handle) ?: listOf(fresh(handle).toPublicJWK()) }

    /** Reads them in one statement, so that a key which is changed meanwhile is not between the two. */
    private fun both(handle: Handle): List<RSAKey>? {
        val found =
            handle
                .createQuery("SELECT name, value FROM secrets WHERE name IN ('$NAME', '$BEFORE')")
                .map { row, _ -> row.getString("name") to row.getBytes("value").decodeToString() }
                .list()
                .toMap()
        val signs = found[NAME]?.let(RSAKey::parse) ?: return null
        return listOf(signs.toPublicJWK()) + stillRead(found[BEFORE])
    }

    /**
     * Makes another pair, which signs from now on; of two that are made at once, by whichever servers, one comes after the
     * other, which is read like any before. The private half of the one before is gone; its public half is read for
     * [KEPT], until all that it signed has run out.
     *
     * @param by who does it, for the audit
     * @param key what the sender calls this request, so that repeating it makes no other pair
     */
    fun renew(
        by: String,
        key: String?,
    ) {
        val request = Repeatable("lti key $by", key, fingerprint = "")
        database.write { handle ->
            if (request.made(handle) != null) return@write
            val now = clock.instant()
            val before = stored(handle) ?: fresh(handle)
            val until = Date.from(now + KEPT)
            val kept = earlier(handle) + RSAKey.Builder(before.toPublicJWK()).expirationTime(until).build()
            put(handle, BEFORE, JWKSet(kept).toString())
            val made = generated()
            put(handle, NAME, made.toJSONString())
            AuditNote(by, course = null, "lti-key", made.keyID, before.keyID).write(handle, now)
            request.remember(handle, made.keyID, now)
        }
    }

    /** A message that whoever has the public half knows to be this server's. */
    internal fun sign(claims: JWTClaimsSet): String {
        val key = pair
        return SignedJWT(JWSHeader.Builder(JWSAlgorithm.RS256).keyID(key.keyID).build(), claims)
            .apply { sign(RSASSASigner(key)) }
            .serialize()
    }

    private fun generated() =
        RSAKeyGenerator(BITS)
            .keyIDFromThumbprint(true)
            .keyUse(KeyUse.SIGNATURE)
            .algorithm(JWSAlgorithm.RS256)
            .generate()

    private fun fresh(handle: Handle): RSAKey {
        handle
            .createUpdate("INSERT INTO secrets (name, value) VALUES (:name, :value) ON CONFLICT DO NOTHING")
            .bind("name", NAME)
            .bind("value", generated().toJSONString().toByteArray())
            .execute()
        return checkNotNull(stored(handle)) { "the key was just stored" }
    }

    private fun put(
        handle: Handle,
        name: String,
        value: String,
    ) = handle
        .createUpdate(
            """INSERT INTO secrets (name, value) VALUES (:name, :value)
               ON CONFLICT (name) DO UPDATE SET value = excluded.value""",
        ).bind("name", name)
        .bind("value", value.toByteArray())
        .execute()

    private fun stored(handle: Handle): RSAKey? = secret(handle, NAME)?.let(RSAKey::parse)

    private fun earlier(handle: Handle): List<RSAKey> = stillRead(secret(handle, BEFORE))

    private fun stillRead(keys: String?): List<RSAKey> =
        keys
            ?.let(JWKSet::parse)
            ?.keys
            .orEmpty()
            .map { it.toRSAKey() }
            .filter { it.expirationTime.toInstant() > clock.instant() }

    private fun secret(
        handle: Handle,
        name: String,
    ): String? =
        handle
            .createQuery("SELECT value FROM secrets WHERE name = :name")
            .bind("name", name)
            .mapTo(ByteArray::class.java)
            .findOne()
            .getOrNull()
            ?.decodeToString()

    companion object {
        /** Time that the public half stays: longer than anything holds that it signed, with clocks that differ by minutes. */
        val KEPT: Duration = Duration.ofHours(1)

        private const val NAME = "lti"
        private const val BEFORE = "lti-before"
        private const val BITS = 2048
    }
}
