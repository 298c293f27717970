package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;

class OwnProcessTest {
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();

    /** Prints its second argument to both streams and ends with its first one. */
    static final class Program {
        private Program() {}

        public static void main(String[] arguments) {
            System.out.println(arguments[1]);
            System.err.println(arguments[1]);
            System.exit(Integer.parseInt(arguments[0]));
        }
    }

    @Test
    void handsOnWhatIsSaidButTheWarningOfVectors() throws IOException, InterruptedException {
        assertTrue(run("0"));
        assertEquals("said", out.toString().strip());
        assertEquals("said", err.toString().strip());
    }

    @Test
    void tellsThatAProgramHasFailed() throws IOException, InterruptedException {
        assertFalse(run("3"));
    }

    @Test
    void drawsAMillionTrianglesInSixHundredMegabytes() throws IOException, InterruptedException {
        List<String> works = PipelineBench.works();
        assertTrue(
                JobProcess.run(
                        works.indexOf("heap"), true, Language.ENGLISH, new PrintStream(out, true)));
        String line = out.toString().strip();
        assertTrue(line.matches(".*, in a heap of 600 MB [|].*[|] drawn"), line);
    }

    private boolean run(String code) throws IOException, InterruptedException {
        return new OwnProcess(List.of(), Program.class, List.of(code, "said"))
                .run(new PrintStream(out, true), new PrintStream(err, true));
    }
}
