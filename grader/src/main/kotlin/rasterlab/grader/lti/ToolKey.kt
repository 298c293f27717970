package rasterlab.grader.lti

import com.nimbusds.jose.JWSAlgorithm
import com.nimbusds.jose.JWSHeader
import com.nimbusds.jose.crypto.RSASSASigner
import com.nimbusds.jose.jwk.JWKSet
import com.nimbusds.jose.jwk.KeyUse
import com.nimbusds.jose.jwk.RSAKey
import com.nimbusds.jose.jwk.gen.RSAKeyGenerator
import com.nimbusds.jwt.JWTClaimsSet
import com.nimbusds.jwt.SignedJWT
import org.jdbi.v3.core.Handle
import rasterlab.grader.storage.Database
import kotlin.jvm.optionals.getOrNull

/** This server's own pair of keys, one for all servers that share the database; made where it is first asked for. */
class ToolKey(
    private val database: Database,
) {
    internal val pair: RSAKey by lazy { RSAKey.parse((database.read(::stored) ?: made()).decodeToString()) }

    /** The public half, as platforms read it. */
    fun publicSet(): String = JWKSet(pair.toPublicJWK()).toString()

    /** A message that whoever has the public half knows to be this server's. */
    internal fun sign(claims: JWTClaimsSet): String =
        SignedJWT(JWSHeader.Builder(JWSAlgorithm.RS256).keyID(pair.keyID).build(), claims)
            .apply { sign(RSASSASigner(pair)) }
            .serialize()

    private fun made(): ByteArray {
        val fresh =
            RSAKeyGenerator(BITS)
                .keyIDFromThumbprint(true)
                .keyUse(KeyUse.SIGNATURE)
                .algorithm(JWSAlgorithm.RS256)
                .generate()
        return database.write { handle ->
            handle
                .createUpdate("INSERT INTO secrets (name, value) VALUES (:name, :value) ON CONFLICT DO NOTHING")
                .bind("name", NAME)
                .bind("value", fresh.toJSONString().toByteArray())
                .execute()
            checkNotNull(stored(handle)) { "the key was just stored" }
        }
    }

    private fun stored(handle: Handle): ByteArray? =
        handle
            .createQuery("SELECT value FROM secrets WHERE name = :name")
            .bind("name", NAME)
            .mapTo(ByteArray::class.java)
            .findOne()
            .getOrNull()

    private companion object {
        const val NAME = "lti"
        const val BITS = 2048
    }
}
