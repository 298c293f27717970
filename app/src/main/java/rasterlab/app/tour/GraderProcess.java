package rasterlab.app.tour;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;

/** The grading server as a child process on a free port. */
final class GraderProcess implements AutoCloseable {
    private static final Duration LONGEST_START = Duration.ofMinutes(2);
    private static final Duration LONGEST_STOP = Duration.ofSeconds(10);
    private static final String ADDRESS = "listening on ";
    private static final String TOKEN = "instructor token: ";

    private final Process process;
    private final Consumer<String> log;
    private final Thread stopper = new Thread(this::kill, "stop the server");
    private final CompletableFuture<URI> address = new CompletableFuture<>();
    private final CompletableFuture<String> token = new CompletableFuture<>();

    private volatile String lastWords = "none";

    private GraderProcess(Process process, Consumer<String> log) {
        this.process = process;
        this.log = log;
        Runtime.getRuntime().addShutdownHook(stopper);
        readOn(this::readOutput, "output of the server");
        readOn(this::readLog, "log of the server");
    }

    private static void readOn(Runnable reading, String name) {
        var thread = new Thread(reading, name);
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * Starts the server with an empty data folder.
     *
     * @param home the folder of the {@code ./lab} script
     * @param data an empty folder
     * @param log told each line that the server says on its error stream, by another thread
     */
    static GraderProcess start(Path home, Path data, Consumer<String> log) throws IOException {
        boolean windows =
                System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
        Path script = home.resolve(windows ? "lab.cmd" : "lab");
        var command =
                new ProcessBuilder(
                        script.toString(),
                        "grader",
                        "serve",
                        "--port",
                        "0",
                        "--data",
                        data.toString());
        return new GraderProcess(command.start(), log);
    }

    /** Where the server listens; waits until it does. */
    URI address() throws InterruptedException {
        return awaited(address, "its address");
    }

    /** The one-time token of the instructor; waits until the server says it. */
    String token() throws InterruptedException {
        return awaited(token, "the instructor's token");
    }

    private <T> T awaited(CompletableFuture<T> said, String what) throws InterruptedException {
        try {
            return said.get(LONGEST_START.toSeconds(), TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException e) {
            throw new IllegalStateException(
                    "the server did not say " + what + "; its last words: " + lastWords, e);
        }
    }

    private void readOutput() {
        try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
            for (String line = output.readLine(); line != null; line = output.readLine()) {
                if (line.startsWith(ADDRESS))
                    address.complete(URI.create(line.substring(ADDRESS.length()).strip()));
                if (line.startsWith(TOKEN)) token.complete(line.substring(TOKEN.length()).strip());
            }
        } catch (IOException e) {
            address.completeExceptionally(e);
        }
        var ended = new IllegalStateException("the server ended");
        address.completeExceptionally(ended);
        token.completeExceptionally(ended);
    }

    private void readLog() {
        try (BufferedReader errors = process.errorReader(StandardCharsets.UTF_8)) {
            for (String line = errors.readLine(); line != null; line = errors.readLine()) {
                lastWords = line;
                log.accept(line);
            }
        } catch (IOException e) {
            lastWords = e.toString();
        }
    }

    /** Asks the server to stop, and makes it if it does not. */
    @Override
    public void close() {
        process.descendants().forEach(ProcessHandle::destroy);
        process.destroy();
        try {
            if (!process.waitFor(LONGEST_STOP.toSeconds(), TimeUnit.SECONDS)) kill();
            process.waitFor();
        } catch (InterruptedException e) {
            kill();
            Thread.currentThread().interrupt();
        }
        forgetStopper();
    }

    private void forgetStopper() {
        try {
            Runtime.getRuntime().removeShutdownHook(stopper);
        } catch (IllegalStateException e) {
            log.accept("the program is ending, so the server is stopped twice: " + e.getMessage());
        }
    }

    private void kill() {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
    }
}
