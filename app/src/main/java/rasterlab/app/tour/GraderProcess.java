package rasterlab.app.tour;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;

/** The grading server as a child process on a free port, with a data folder that goes with it. */
final class GraderProcess implements AutoCloseable {
    private static final Duration LONGEST_START = Duration.ofMinutes(2);
    private static final Duration LONGEST_STOP = Duration.ofSeconds(10);

    /**
     * The longest that a stop may take once the program was told to end, by Ctrl+C for instance.
     */
    private static final Duration LONGEST_LAST_STOP = Duration.ofSeconds(3);

    private static final String ADDRESS = "listening on ";
    private static final String TOKEN = "instructor token: ";

    private final Process process;
    private final TemporaryFolder data;
    private final Consumer<String> log;
    private final Thread stopper = new Thread(this::abandon, "stop the server");
    private final CompletableFuture<URI> address = new CompletableFuture<>();
    private final CompletableFuture<String> token = new CompletableFuture<>();

    private volatile String lastWords = "none";

    private GraderProcess(Process process, TemporaryFolder data, Consumer<String> log) {
        this.process = process;
        this.data = data;
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
     * @param log told each line that the server says on its error stream, by another thread
     */
    static GraderProcess start(Path home, Consumer<String> log) throws IOException {
        boolean windows =
                System.getProperty("os.name").toLowerCase(Locale.ROOT).startsWith("windows");
        Path script = home.resolve(windows ? "lab.cmd" : "lab");
        var data = new TemporaryFolder();
        var command =
                new ProcessBuilder(
                        script.toString(),
                        "grader",
                        "serve",
                        "--port",
                        "0",
                        "--data",
                        data.path().toString());
        try {
            return new GraderProcess(command.start(), data, log);
        } catch (IOException e) {
            data.close();
            throw e;
        }
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

    /** Asks the server to stop, and makes it if it does not; its data go too. */
    @Override
    public void close() throws IOException {
        stop(LONGEST_STOP);
        forgetStopper();
        data.close();
    }

    /** When the program ends first: the server is given little time, and nothing of it is left. */
    void abandon() {
        stop(LONGEST_LAST_STOP);
        try {
            data.close();
        } catch (IOException e) {
            log.accept("the server's data stay in " + data.path() + ": " + e.getMessage());
        }
    }

    /**
     * The server is asked before its children, so that it ends them itself; where the script is not
     * replaced by the server, as on Windows, the server is one of the children that are left.
     */
    private void stop(Duration longest) {
        try {
            stop(process.toHandle(), longest);
            process.waitFor();
        } catch (InterruptedException e) {
            kill();
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Stops level by level: a child is asked only once its parent has ended. Were all asked at
     * once, a parent that sees its child killed could say so into a closed pipe, and end of that.
     */
    private static void stop(ProcessHandle parent, Duration longest) throws InterruptedException {
        List<ProcessHandle> children = parent.children().toList();
        parent.destroy();
        try {
            parent.onExit().get(longest.toSeconds(), TimeUnit.SECONDS);
        } catch (ExecutionException | TimeoutException e) {
            parent.destroyForcibly();
        }
        for (ProcessHandle child : children) stop(child, longest);
    }

    private void forgetStopper() {
        try {
            Runtime.getRuntime().removeShutdownHook(stopper);
        } catch (IllegalStateException ending) {
            awaitEnd();
        }
    }

    /** The program is ending: nothing more is to be made of a server that was stopped for it. */
    private static void awaitEnd() {
        while (true) LockSupport.park();
    }

    private void kill() {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        process.destroyForcibly();
    }
}
