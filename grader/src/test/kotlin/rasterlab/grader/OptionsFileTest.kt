package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.Arguments
import org.junit.jupiter.params.provider.Arguments.argumentSet
import org.junit.jupiter.params.provider.MethodSource
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import kotlin.io.path.writeText

class OptionsFileTest {
    @TempDir
    lateinit var folder: Path

    /** The one line with which serve refuses to start by this file, without the file's name. */
    private fun refusal(
        yaml: String,
        vararg options: String,
    ): String {
        val file = folder.resolve("s.yaml").apply { writeText(yaml) }
        val printed = StringWriter()
        val commands = commandLine().setErr(PrintWriter(printed, true))
        assertEquals(2, commands.execute("serve", "--config", "$file", *options), "$printed")
        return "$printed".trim().removePrefix("./lab grader serve: ").removePrefix("$file, ")
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    fun isToldWithItsLine(
        said: String,
        yaml: String,
    ) = assertEquals(said, refusal(yaml))

    @Test
    @DisplayName("a file in which nothing is set keeps the server from starting, or its values are not taken")
    fun valuesOfTheFileAreTaken() {
        assertEquals("--workers 0: expected 1 to 64", refusal("# a course\n\nhost: 127.0.0.1\nworkers: 0\n"))
        assertEquals("--port 65536: expected 0 to 65535", refusal("", "--port", "65536"))
    }

    @Test
    @DisplayName("the file counts more than what is given on the command line")
    fun optionsCountMore() =
        assertEquals("--workers 65: expected 1 to 64", refusal("workers: 0\nport: 0\n", "--workers", "65"))

    private companion object {
        const val KNOWN =
            "data, db, entries-per-minute, exam, exercises, host, java-images, name, oidc-claim, oidc-client-id, " +
                "oidc-client-secret, oidc-issuer, port, proxy, public-address, sign-in-column, " +
                "sign-in-header, sign-in-staff, submissions-per-minute, tls-cert, tls-key, waiting, " +
                "workers"

        @JvmStatic
        fun mistakes(): List<Arguments> =
            listOf(
                argumentSet(
                    "an unknown key is passed over",
                    "line 2: no setting 'prot'; there are $KNOWN",
                    "port: 0\nprot: 8080\n",
                ),
                argumentSet(
                    "the heap is set too late",
                    "line 1: no setting 'heap'; there are $KNOWN",
                    "heap: 512",
                ),
                argumentSet(
                    "a text is taken for a number",
                    "line 1: port: expected a whole number, got 'eighty'",
                    "port: eighty",
                ),
                argumentSet(
                    "a fraction is cut to a number",
                    "line 1: workers: expected a whole number, got '1.5'",
                    "workers: 1.5",
                ),
                argumentSet(
                    "a number that no int holds is cut",
                    "line 1: port: expected a whole number, got '4294967296'",
                    "port: 4294967296",
                ),
                argumentSet(
                    "a word is taken for false",
                    "line 2: exam: expected true or false, got 'perhaps'",
                    "\nexam: perhaps",
                ),
                argumentSet(
                    "a number is taken for a folder",
                    "line 1: data: expected a text, got '2026'; write it in quotes where it looks like a number",
                    "data: 2026",
                ),
                argumentSet(
                    "the last of two values wins",
                    "line 3: 'port' is set a second time",
                    "port: 1\n\nport: 2\n",
                ),
                argumentSet(
                    "a list is flattened",
                    "line 1: expected a name and one value, such as 'port: 8080'",
                    "port: [1, 2]",
                ),
                argumentSet(
                    "a lone word is passed over",
                    "line 1: expected a name and one value, such as 'port: 8080'",
                    "port",
                ),
                argumentSet(
                    "an empty value stands for a default",
                    "line 1: expected a name and one value, such as 'port: 8080'",
                    "port:\n",
                ),
            )
    }
}
