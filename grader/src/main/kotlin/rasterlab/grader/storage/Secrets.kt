package rasterlab.grader.storage

import org.jdbi.v3.core.Handle
import java.security.MessageDigest
import java.security.SecureRandom
import java.util.Base64
import javax.crypto.Mac
import javax.crypto.spec.SecretKeySpec

/** Ids, tokens and hashes, all as base64url text without padding. */
object Secrets {
    private val random = SecureRandom()
    private val base64 = Base64.getUrlEncoder().withoutPadding()

    /** Names a row to the outside; nearly 128 bits cannot be guessed by trying. */
    fun newId(): String = typed(16)

    /** Lets its holder in; nearly 256 bits. */
    fun newToken(): String = typed(32)

    /** Random text that people type behind a command, so that it begins like no option, with '-'. */
    private fun typed(count: Int): String =
        generateSequence { base64.encodeToString(bytes(count)) }.first { !it.startsWith('-') }

    fun newSeed(): Long = random.nextLong()

    /**
     * The hash that is stored instead of a token. A plain SHA-256 is enough: a slow, salted hash protects
     * passwords that people choose, and nobody can search 2²⁵⁶ random tokens.
     */
    fun hash(text: String): String =
        base64.encodeToString(MessageDigest.getInstance("SHA-256").digest(text.toByteArray()))

    /** A short code of [length] letters and digits that are not mistaken for each other when read aloud or copied. */
    fun newCode(length: Int): String = String(CharArray(length) { CODE_LETTERS[random.nextInt(CODE_LETTERS.length)] })

    /** 256 bits that only this server can compute from [text]: the same each time, and stored nowhere. */
    fun derive(
        handle: Handle,
        text: String,
    ): String {
        val mac = Mac.getInstance("HmacSHA256")
        mac.init(SecretKeySpec(serverKey(handle), "HmacSHA256"))
        return base64.encodeToString(mac.doFinal(text.toByteArray()))
    }

    private fun serverKey(handle: Handle): ByteArray {
        handle
            .createUpdate("INSERT INTO secrets (name, value) VALUES ('derive', :value) ON CONFLICT DO NOTHING")
            .bind("value", bytes(32))
            .execute()
        return handle.createQuery("SELECT value FROM secrets WHERE name = 'derive'").mapTo(ByteArray::class.java).one()
    }

    private fun bytes(count: Int) = ByteArray(count).also(random::nextBytes)

    private const val CODE_LETTERS = "23456789ABCDEFGHJKLMNPQRSTUVWXYZ"
}
