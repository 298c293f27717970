package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Language;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.Repository;
import rasterlab.tests.process.JavaCommand;

@Tag("slow")
class OwnProcessTest {
    private static final String SAID = "1280×720 → ещё";

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    /** Says something on both streams and ends with its argument. */
    static final class Program {
        private Program() {}

        public static void main(String[] code) throws IOException {
            byte[] said = (SAID + "\n").getBytes(StandardCharsets.UTF_8);
            System.out.write(said);
            System.err.write(said);
            System.exit(Integer.parseInt(code[0]));
        }
    }

    /** Writes its number to a file, asks who started it to end, and never ends itself. */
    static final class Endless {
        private Endless() {}

        public static void main(String[] file) throws IOException {
            Files.writeString(Path.of(file[0]), String.valueOf(ProcessHandle.current().pid()));
            ProcessHandle.current().parent().orElseThrow().destroy();
            while (true) LockSupport.park();
        }
    }

    /** Starts one that never ends. */
    static final class Stopped {
        private Stopped() {}

        public static void main(String[] file) throws IOException, InterruptedException {
            new OwnProcess(List.of(), Endless.class, List.of(file)).run(System.out, System.err);
        }
    }

    @Test
    void handsOnWhatIsSaidButTheWarningOfVectors() throws IOException, InterruptedException {
        assertEquals(0, run("0"));
        assertEquals(SAID, out.toString(StandardCharsets.UTF_8).strip());
        assertEquals(SAID, err.toString(StandardCharsets.UTF_8).strip());
    }

    @Test
    void tellsWhatAProgramEndedWith() throws IOException, InterruptedException {
        assertEquals(3, run("3"));
    }

    @Test
    void endsWithWhoStartedItAndLeavesNoFiles(@TempDir Path temporary, @TempDir Path other)
            throws IOException {
        Path number = other.resolve("number");
        var run =
                ChildProcess.run(
                        Repository.root(),
                        Map.of(),
                        Duration.ofMinutes(1),
                        JavaCommand.of(
                                List.of("-Djava.io.tmpdir=" + temporary),
                                Stopped.class.getName(),
                                List.of(number.toString())));
        long pid = Long.parseLong(Files.readString(number));
        assertFalse(ProcessHandle.of(pid).map(ProcessHandle::isAlive).orElse(false), run::err);
        try (Stream<Path> left = Files.list(temporary)) {
            assertEquals(List.of(), left.toList());
        }
    }

    @Test
    void drawsAMillionTrianglesInSixHundredMegabytes() throws IOException, InterruptedException {
        int heap = PipelineBench.works().indexOf("heap");
        assertEquals(0, JobProcess.run(heap, true, Language.ENGLISH, stream(out), stream(err)));
        String line = out.toString(StandardCharsets.UTF_8).strip();
        assertTrue(line.matches(".*, in a heap of 600 MB [|].*[|] drawn"), line);
    }

    private int run(String code) throws IOException, InterruptedException {
        return new OwnProcess(List.of(), Program.class, List.of(code))
                .run(stream(out), stream(err));
    }

    private static PrintStream stream(ByteArrayOutputStream to) {
        return new PrintStream(to, true, StandardCharsets.UTF_8);
    }
}
