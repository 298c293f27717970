package rasterlab.grader.certificate

import java.nio.file.Path
import java.security.KeyStore
import java.util.Base64
import javax.net.ssl.SSLContext
import javax.net.ssl.TrustManagerFactory
import kotlin.io.path.inputStream
import kotlin.io.path.writeText

/**
 * A certificate for this machine and its key, made by the JDK's keytool and written as PEM.
 *
 * @param trusting how a client connects that believes this certificate
 */
class MadeCertificate private constructor(
    val certificate: Path,
    val key: Path,
    val trusting: SSLContext,
) {
    companion object {
        private const val WORD = "of-this-test-only"
        private val lines = Base64.getMimeEncoder(64, "\n".toByteArray())

        /** @param more options of `keytool -genkeypair` */
        fun make(
            folder: Path,
            name: String,
            algorithm: String = "EC",
            vararg more: String,
        ): MadeCertificate {
            val store = folder.resolve("$name.p12")
            val keytool = Path.of(System.getProperty("java.home"), "bin", "keytool")
            val command =
                "-genkeypair -alias server -keyalg $algorithm -dname CN=localhost -ext san=ip:127.0.0.1 " +
                    "-storetype PKCS12 -storepass $WORD -keystore"
            val run =
                ProcessBuilder(listOf("$keytool") + command.split(' ') + "$store" + more)
                    .redirectErrorStream(true)
                    .start()
            val said = run.inputReader().readText()
            check(run.waitFor() == 0) { said }
            val keys = KeyStore.getInstance("PKCS12")
            store.inputStream().use { keys.load(it, WORD.toCharArray()) }
            return MadeCertificate(
                pem(folder.resolve("$name.crt"), "CERTIFICATE", keys.getCertificate("server").encoded),
                pem(folder.resolve("$name.key"), "PRIVATE KEY", keys.getKey("server", WORD.toCharArray()).encoded),
                trusting(keys),
            )
        }

        fun pem(
            file: Path,
            label: String,
            bytes: ByteArray,
        ): Path {
            file.writeText("-----BEGIN $label-----\n${lines.encodeToString(bytes)}\n-----END $label-----\n")
            return file
        }

        private fun trusting(keys: KeyStore): SSLContext {
            val trusted = KeyStore.getInstance("PKCS12").apply { load(null, null) }
            trusted.setCertificateEntry("server", keys.getCertificate("server"))
            val managers = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm())
            managers.init(trusted)
            return SSLContext.getInstance("TLS").apply { init(null, managers.trustManagers, null) }
        }
    }
}
