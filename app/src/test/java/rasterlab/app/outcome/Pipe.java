package rasterlab.app.outcome;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A pipe into which nobody writes: whoever opens it to read waits for ever. */
public final class Pipe {
    private Pipe() {}

    /** Makes one of that name, or has the test skipped where the system's mkfifo is missing. */
    public static Path at(Path file) throws IOException, InterruptedException {
        boolean has = Files.isExecutable(Path.of("/usr/bin/mkfifo"));
        assumeTrue(has, "/usr/bin/mkfifo is missing");
        int exit = new ProcessBuilder("/usr/bin/mkfifo", file.toString()).start().waitFor();
        assumeTrue(exit == 0, "mkfifo cannot make a pipe in " + file.getParent());
        return file;
    }
}
