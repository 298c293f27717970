// The server's own certificate, for TLS without a proxy in front.
package rasterlab.grader.certificate

import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.security.GeneralSecurityException
import java.security.KeyFactory
import java.security.KeyStore
import java.security.PrivateKey
import java.security.PublicKey
import java.security.Signature
import java.security.cert.CertificateException
import java.security.cert.CertificateFactory
import java.security.cert.X509Certificate
import java.security.spec.PKCS8EncodedKeySpec
import java.time.InstantSource
import java.util.Base64
import javax.net.ssl.KeyManagerFactory
import javax.net.ssl.SSLContext

/**
 * The server's certificate, with those that vouch for it behind it, and its private key. Both are only ever in memory
 * and in the two files that they come from.
 */
class OwnCertificate private constructor(
    private val chain: List<X509Certificate>,
    private val key: PrivateKey,
) {
    /** Returns what the connections of this server are encrypted by. */
    fun encryption(): SSLContext {
        val keys = KeyStore.getInstance("PKCS12").apply { load(null, null) }
        keys.setKeyEntry("server", key, NO_PASSWORD, chain.toTypedArray())
        val managers = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm())
        managers.init(keys, NO_PASSWORD)
        return SSLContext.getInstance("TLS").apply { init(managers.keyManagers, null, null) }
    }

    companion object {
        private val NO_PASSWORD = CharArray(0)
        private val BLOCK = Regex("-----BEGIN ([A-Z0-9 ]+)-----(.*?)-----END \\1-----", RegexOption.DOT_MATCHES_ALL)
        private const val MOST_BYTES = 1L shl 20
        private const val CERTIFICATE = "CERTIFICATE"
        private const val KEY = "PRIVATE KEY"
        private const val LOCKED_KEY = "ENCRYPTED PRIVATE KEY"

        /**
         * Reads both files, which are in PEM; the certificates stand in the order in which each vouches for the one
         * before it.
         *
         * @throws CannotStart for what would make browsers refuse the server, or the server fail at the first of them
         */
        fun read(
            certificate: Path,
            key: Path,
            clock: InstantSource,
        ): OwnCertificate {
            val chain =
                blocks(
                    certificate,
                ).filter { it.first == CERTIFICATE }.map { certificate(certificate, it.second) }
            val own = chain.firstOrNull() ?: throw CannotStart(StartFailure.TLS_CERTIFICATE, certificate)
            val now = clock.instant()
            val from = own.notBefore.toInstant()
            val until = own.notAfter.toInstant()
            if (now < from) throw CannotStart(StartFailure.TLS_EARLY, certificate, from)
            if (now > until) throw CannotStart(StartFailure.TLS_EXPIRED, certificate, until)
            val secret = privateKey(key, own.publicKey.algorithm)
            if (!fit(own.publicKey, secret)) throw CannotStart(StartFailure.TLS_MISMATCH, key, certificate)
            return OwnCertificate(chain, secret)
        }

        /** The blocks of a file in PEM, each with its label. */
        private fun blocks(file: Path): List<Pair<String, String>> {
            try {
                if (Files.size(file) > MOST_BYTES) throw CannotStart(StartFailure.TLS_FILE, file, "> $MOST_BYTES bytes")
                val text = Files.readString(file, Charsets.ISO_8859_1)
                return BLOCK.findAll(text).map { it.groupValues[1] to it.groupValues[2] }.toList()
            } catch (failure: IOException) {
                throw CannotStart(StartFailure.TLS_FILE, file, failure.javaClass.simpleName, cause = failure)
            }
        }

        private fun certificate(
            file: Path,
            block: String,
        ): X509Certificate =
            try {
                val factory = CertificateFactory.getInstance("X.509")
                factory.generateCertificate(decoded(block).inputStream()) as X509Certificate
            } catch (failure: CertificateException) {
                throw CannotStart(
                    StartFailure.TLS_BROKEN,
                    file,
                    failure.message
                        .orEmpty()
                        .lines()
                        .first(),
                    cause = failure,
                )
            } catch (failure: IllegalArgumentException) {
                throw CannotStart(StartFailure.TLS_BROKEN, file, failure.message.orEmpty(), cause = failure)
            }

        private fun privateKey(
            file: Path,
            algorithm: String,
        ): PrivateKey {
            val blocks = blocks(file)
            val older = blocks.firstOrNull { it.first.endsWith(" $KEY") && it.first != LOCKED_KEY }
            val block = blocks.firstOrNull { it.first == KEY }
            if (block == null) {
                if (blocks.any { it.first == LOCKED_KEY }) throw CannotStart(StartFailure.TLS_LOCKED, file)
                throw older?.let { CannotStart(StartFailure.TLS_OLDER, file, it.first) }
                    ?: CannotStart(StartFailure.TLS_KEY, file)
            }
            return try {
                KeyFactory.getInstance(algorithm).generatePrivate(PKCS8EncodedKeySpec(decoded(block.second)))
            } catch (failure: GeneralSecurityException) {
                throw CannotStart(StartFailure.TLS_OTHER_KEY, file, algorithm, cause = failure)
            } catch (failure: IllegalArgumentException) {
                throw CannotStart(StartFailure.TLS_OTHER_KEY, file, algorithm, cause = failure)
            }
        }

        /** @throws IllegalArgumentException where it is no Base64 */
        private fun decoded(block: String): ByteArray = Base64.getDecoder().decode(block.filterNot(Char::isWhitespace))

        /** Whether what the one signs the other takes for its own. */
        private fun fit(
            public: PublicKey,
            private: PrivateKey,
        ): Boolean {
            val method =
                when (val algorithm = private.algorithm) {
                    "RSA" -> "SHA256withRSA"
                    "EC" -> "SHA256withECDSA"
                    else -> algorithm
                }
            val word = "rasterlab".toByteArray()
            return try {
                val signed =
                    Signature.getInstance(method).run {
                        initSign(private)
                        update(word)
                        sign()
                    }
                Signature.getInstance(method).run {
                    initVerify(public)
                    update(word)
                    verify(signed)
                }
            } catch (differ: GeneralSecurityException) {
                false
            }
        }
    }
}
