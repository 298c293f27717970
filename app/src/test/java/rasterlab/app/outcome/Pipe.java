package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * A pipe, which nobody should open: a real one would have its reader wait for ever. Who opens this
 * one gets a few bytes, so that a test fails and does not hang.
 */
public final class Pipe {
    private static final Path MAKER = Path.of("/usr/bin/mkfifo");

    private Pipe() {}

    /** Makes one of that name, or has the test skipped where the system's mkfifo is missing. */
    public static Path at(Path file) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(MAKER), MAKER + " is missing");
        int exit = new ProcessBuilder(MAKER.toString(), file.toString()).start().waitFor();
        assumeTrue(exit == 0, "mkfifo cannot make a pipe in " + file.getParent());
        var writer = new Thread(() -> write(file), "pipe");
        writer.setDaemon(true);
        writer.start();
        return file;
    }

    /** Waits until somebody opens the pipe to read. */
    private static void write(Path file) {
        try {
            Files.writeString(file, "bytes of a pipe", StandardOpenOption.WRITE);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
