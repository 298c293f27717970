package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Runs programs of the system that do one thing and end. */
final class SystemCommand {
    private SystemCommand() {}

    static void run(String... command) throws IOException, InterruptedException {
        run(List.of(command));
    }

    /**
     * Runs one that puts something back.
     *
     * @throws IOException as {@link #run}, and where it was not waited for
     */
    static void runAtEnd(String... command) throws IOException {
        try {
            run(command);
        } catch (InterruptedException hurried) {
            Thread.currentThread().interrupt();
            throw new IOException(command[0] + " was not waited for", hurried);
        }
    }

    /**
     * Waits for its end.
     *
     * @throws IOException with what it said, where it is not there or fails
     */
    static void run(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (process.waitFor() != 0)
            throw new IOException(command.get(0) + ": " + said.strip().replaceAll("\\s+", " "));
    }
}
