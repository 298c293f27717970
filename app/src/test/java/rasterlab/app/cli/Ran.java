package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** The outcome of one command. */
public record Ran(int exitCode, String out, String err) {
    /** Runs a command with nothing to read. */
    public static Ran lab(String... arguments) {
        return labReading("", arguments);
    }

    public static Ran labReading(String in, String... arguments) {
        var out = new ByteArrayOutputStream();
        var err = new ByteArrayOutputStream();
        int exitCode =
                Lab.run(
                        arguments,
                        new ByteArrayInputStream(in.getBytes(StandardCharsets.UTF_8)),
                        new PrintStream(out),
                        new PrintStream(err));
        return new Ran(
                exitCode,
                out.toString(StandardCharsets.UTF_8),
                err.toString(StandardCharsets.UTF_8));
    }

    /**
     * Checks that nothing came on standard output, and exactly this one line on the error stream.
     */
    public void assertComplains(int expectedCode, String line) {
        assertEquals(line + System.lineSeparator(), err);
        assertEquals("", out);
        assertEquals(expectedCode, exitCode);
    }

    /** The command did its work and said nothing that looks like a fault. */
    public void assertDone() {
        assertFalse(err.contains("\tat "), err);
        assertEquals(0, exitCode, err);
    }
}
