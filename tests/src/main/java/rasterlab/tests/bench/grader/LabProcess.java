package rasterlab.tests.bench.grader;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;

/** A server or a worker as {@code ./lab grader} starts it. */
final class LabProcess implements AutoCloseable {
    private static final int START_MINUTES = 5;
    private static final int STOP_SECONDS = 60;

    private final Process process;
    private final BufferedReader lines;
    private final Path errors;

    private LabProcess(Process process, Path errors) {
        this.process = process;
        this.lines = process.inputReader(StandardCharsets.UTF_8);
        this.errors = errors;
    }

    /**
     * @param errors the file for what it says on its standard error
     */
    static LabProcess start(LabCall call, Path errors) throws IOException {
        return new LabProcess(call.process().redirectError(errors.toFile()).start(), errors);
    }

    /**
     * The rest of the next line that begins with some words.
     *
     * @throws IOException where it ends without, or says nothing for minutes
     */
    String after(String words) throws IOException {
        try {
            return CompletableFuture.supplyAsync(() -> readTo(words))
                    .orTimeout(START_MINUTES, TimeUnit.MINUTES)
                    .join();
        } catch (CompletionException without) {
            String said = Files.readString(errors).strip();
            throw new IOException("no line '" + words.strip() + " …', but: " + said, without);
        }
    }

    private String readTo(String words) {
        try {
            for (String line = lines.readLine(); line != null; line = lines.readLine())
                if (line.startsWith(words)) return line.substring(words.length());
            throw new IOException("the process ended");
        } catch (IOException unread) {
            throw new UncheckedIOException(unread);
        }
    }

    long pid() {
        return process.pid();
    }

    /** The processes that it compiles and runs sources in. */
    List<ProcessHandle> children() {
        return process.descendants().toList();
    }

    /** Ends it as a power cut would. */
    void kill() {
        process.destroyForcibly().onExit().join();
    }

    /** Asks it to end, and ends it where that takes too long. */
    @Override
    public void close() {
        process.destroy();
        try {
            if (!process.waitFor(STOP_SECONDS, TimeUnit.SECONDS)) process.destroyForcibly();
        } catch (InterruptedException hurried) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
