package rasterlab.grader.certificate

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import rasterlab.grader.commandLine
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText

/** Starts the server by files that it must refuse, each with what is wrong with it. */
class RefusedCertificateTest {
    @ParameterizedTest(name = "{argumentSetName} is served with, or refused without the reason")
    @MethodSource("mistakes")
    fun isToldWithItsFile(
        certificate: String,
        key: String,
        said: String,
    ) = assertEquals(said, refusal("--tls-cert", "$folder/$certificate", "--tls-key", "$folder/$key"))

    @ParameterizedTest(name = "a certificate of {argumentSetName} says nothing of its dates")
    @MethodSource("dates")
    fun isValidToday(
        start: String,
        said: String,
    ) {
        val made = MadeCertificate.make(folder, "dated$start", "EC", "-startdate", start, "-validity", "2")
        val refused = refusal("--tls-cert", "${made.certificate}", "--tls-key", "${made.key}")
        assertTrue(Regex(said).matches(refused), refused)
    }

    @Test
    @DisplayName("a certificate without its key is passed over")
    fun oneAloneIsRefused() {
        val said = "--tls-cert and --tls-key belong together: expected both or neither"
        assertEquals(said, refusal("--tls-cert", "$folder/a.crt"))
        assertEquals(said, refusal("--tls-key", "$folder/a.key"))
    }

    private fun refusal(vararg options: String): String {
        val printed = StringWriter()
        val data = folder.resolve("data")
        val commands = commandLine().setErr(PrintWriter(printed, true))
        assertEquals(2, commands.execute("serve", "--port", "0", "--data", "$data", *options), "$printed")
        assertFalse(data.exists(), "a folder is left behind")
        return "$printed".trim().removePrefix("./lab grader serve: ").replace("$folder/", "")
    }

    private companion object {
        @TempDir
        lateinit var folder: Path

        @BeforeAll
        @JvmStatic
        fun write() {
            MadeCertificate.make(folder, "a")
            MadeCertificate.make(folder, "b")
            MadeCertificate.make(folder, "rsa", "RSA")
            val secret = folder.resolve("a.key").readText()
            for ((name, label) in listOf("locked" to "ENCRYPTED PRIVATE KEY", "older" to "EC PRIVATE KEY")) {
                folder.resolve("$name.key").writeText(secret.replace("PRIVATE KEY", label))
            }
            folder.resolve("cut.crt").writeText(folder.resolve("a.crt").readText().replace(Regex("\n[^-]{99}"), "\n"))
            folder.resolve("notes.txt").writeText("no certificate\n")
        }

        @JvmStatic
        fun mistakes() =
            listOf(
                argumentSet(
                    "a file that is not there",
                    "none.crt",
                    "a.key",
                    "none.crt: cannot be read (NoSuchFileException); expected a file in PEM",
                ),
                argumentSet(
                    "a text for a certificate",
                    "notes.txt",
                    "a.key",
                    "notes.txt: holds no certificate; expected PEM with a line -----BEGIN CERTIFICATE-----",
                ),
                argumentSet(
                    "the key for a certificate",
                    "a.key",
                    "a.key",
                    "a.key: holds no certificate; expected PEM with a line -----BEGIN CERTIFICATE-----",
                ),
                argumentSet(
                    "the certificate for a key",
                    "a.crt",
                    "a.crt",
                    "a.crt: holds no private key; expected PEM with a line -----BEGIN PRIVATE KEY-----",
                ),
                argumentSet(
                    "a locked key",
                    "a.crt",
                    "locked.key",
                    "locked.key: the private key is locked by a password; openssl pkey -in locked.key -out NEW " +
                        "writes it without",
                ),
                argumentSet(
                    "a key of the older form",
                    "a.crt",
                    "older.key",
                    "older.key: the private key is in an older form (EC PRIVATE KEY); openssl pkey -in older.key " +
                        "-out NEW writes it as PKCS#8",
                ),
                argumentSet(
                    "another's key",
                    "a.crt",
                    "b.key",
                    "b.key: the private key does not belong to the certificate in a.crt",
                ),
                argumentSet(
                    "a key of another kind",
                    "a.crt",
                    "rsa.key",
                    "rsa.key: the private key cannot be read as one of the certificate's kind, EC",
                ),
            )

        @JvmStatic
        fun dates() =
            listOf(
                argumentSet("last week", "-10d", "dated-10d.crt: the certificate was valid until .*Z; get a new one"),
                argumentSet(
                    "next week",
                    "+7d",
                    "dated\\+7d.crt: the certificate is not valid before .*Z; look at this machine's clock",
                ),
            )
    }

    @Test
    @DisplayName("half a certificate is served with, or its reason has many lines")
    fun halfACertificateIsRefused() {
        val said = refusal("--tls-cert", "$folder/cut.crt", "--tls-key", "$folder/a.key")
        assertTrue(said.startsWith("cut.crt: a certificate in it cannot be read ("), said)
        assertEquals(1, said.lines().size)
    }
}
