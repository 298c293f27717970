package rasterlab.tests.grading;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.tests.ChildProcess;

/**
 * {@code ./lab grader serve} that must not start: one line with the place and the value, exit 2.
 */
@Tag("slow")
class RefusedStartTest {
    @TempDir private Path folder;

    /** There is no bubblewrap without programs on the PATH, as on Windows and macOS. */
    @Test
    void noExamIsGradedWithoutIsolationByTheSystem() throws IOException {
        var nothing = Files.createDirectory(folder.resolve("no programs"));
        assertRefused(
                "missing here: namespaces and a root of its own, and a network that is cut off;"
                        + " bubblewrap (bwrap is not on the PATH)",
                Map.of("PATH", nothing.toString()),
                "--port",
                "0",
                "--exam");
    }

    /** Root's processes are counted by no limit. */
    @Test
    void noExamIsGradedByRoot() throws IOException {
        assumeTrue("0".equals(String.valueOf(uid())), "this account is not root");
        assertRefused(
                "a limit on the number of processes (Rasterlab runs as root",
                Map.of(),
                "--port",
                "0",
                "--exam");
    }

    private static Object uid() throws IOException {
        var self = Path.of("/proc/self");
        return Files.exists(self) ? Files.getAttribute(self, "unix:uid") : "none";
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void tellsTheValueAndWhatIsAllowed(String words, List<String> arguments) {
        assertRefused(words, Map.of(), arguments.toArray(String[]::new));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a port that does not exist is taken",
                        "--port 65536: expected 0 to 65535",
                        List.of("--port", "65536")),
                argumentSet(
                        "a server without workers grades nothing",
                        "--workers 0: expected 1 to 64",
                        List.of("--port", "0", "--workers", "0")),
                argumentSet(
                        "an unknown host is shown as a stack trace",
                        "--host no.such.host.invalid: no such host",
                        List.of("--port", "0", "--host", "no.such.host.invalid")),
                argumentSet(
                        "missing exercises are left out silently",
                        "--exercises: none: no such folder",
                        List.of("--port", "0", "--exercises", "none")),
                argumentSet(
                        "a database of another kind is taken",
                        "--db mysql://host/db: expected sqlite:FILE or postgresql:",
                        List.of("--port", "0", "--db", "mysql://host/db")),
                argumentSet(
                        "a database that does not answer leaves a folder",
                        "postgresql://u@no.such.host.invalid:5432/db: no PostgreSQL server answers",
                        List.of(
                                "--port",
                                "0",
                                "--db",
                                "postgresql://u:hush@no.such.host.invalid/db")));
    }

    @Test
    void aPortThatIsTakenIsNamed() throws IOException {
        try (var taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
            var port = String.valueOf(taken.getLocalPort());
            assertRefused("cannot listen on 127.0.0.1:" + port, Map.of(), "--port", port);
        }
    }

    private void assertRefused(String words, Map<String, String> environment, String... options) {
        var command = ServerProcess.command(folder.resolve("course"), options);
        var run = ChildProcess.run(folder, environment, Duration.ofMinutes(5), command);
        assertEquals(2, run.exit(), run.err());
        assertEquals("", run.out());
        assertEquals(1, run.err().lines().count(), run.err());
        assertTrue(run.err().contains(words), run.err());
        assertFalse(Files.exists(folder.resolve("course")), "a refused start leaves a folder");
    }
}
