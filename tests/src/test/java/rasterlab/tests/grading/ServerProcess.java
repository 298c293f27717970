package rasterlab.tests.grading;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import rasterlab.tests.ChildProcess;
import rasterlab.tests.process.JavaCommand;

/**
 * {@code ./lab grader serve} as a real child process on a free port.
 *
 * @param address where it listens
 * @param token of the instructor; empty when the data folder was not new
 */
public record ServerProcess(Process process, URI address, String token, Path log)
        implements AutoCloseable {
    /** Images of Java that all tests of the module share, as each takes seconds to make. */
    static final Path IMAGES = Path.of("target", "java-images").toAbsolutePath();

    private static final String LISTENING = "listening on ";
    private static final String TOKEN = "instructor token: ";

    public static ServerProcess start(Path data) throws IOException {
        return start(command(data, "--port", "0"), data);
    }

    /** A server with no more than so many open files, which limits no child that grades. */
    static ServerProcess withFiles(int most, Path data) throws IOException {
        var limit = "ulimit -Sn " + most + " && exec \"$@\"";
        var command = new ArrayList<>(List.of("sh", "-c", limit, "sh"));
        command.addAll(command(data, "--port", "0"));
        // Otherwise Java takes as many as it may.
        command.add(5, "-XX:-MaxFDLimit");
        return start(command, data);
    }

    private static ServerProcess start(List<String> command, Path data) throws IOException {
        var isNew = !Files.exists(data);
        var log = Files.createTempFile("rasterlab-server", ".log");
        var process = new ProcessBuilder(command).redirectError(log.toFile()).start();
        var out = process.inputReader(StandardCharsets.UTF_8);
        try {
            var address = lineAfter(LISTENING, out, log);
            var token = isNew ? lineAfter(TOKEN, out, log) : "";
            return new ServerProcess(process, URI.create(address), token, log);
        } catch (Throwable failure) {
            process.destroyForcibly();
            throw failure;
        }
    }

    /** The call of the server on that data folder, with more options. */
    static List<String> command(Path data, String... options) {
        var java = new ArrayList<>(ChildProcess.SHORT_LIVED);
        if (Runtime.version().feature() >= 24) java.add("--enable-native-access=ALL-UNNAMED");
        var arguments = new ArrayList<>(List.of("serve", "--data", data.toString()));
        arguments.addAll(List.of("--java-images", IMAGES.toString()));
        arguments.addAll(List.of(options));
        return JavaCommand.of(java, "rasterlab.grader.MainKt", arguments);
    }

    private static String lineAfter(String start, BufferedReader out, Path log) throws IOException {
        var line =
                CompletableFuture.supplyAsync(
                                () -> {
                                    try {
                                        return out.readLine();
                                    } catch (IOException e) {
                                        throw new java.io.UncheckedIOException(e);
                                    }
                                })
                        .orTimeout(2, TimeUnit.MINUTES)
                        .join();
        if (line == null || !line.startsWith(start))
            throw new AssertionError(
                    "expected a line '"
                            + start
                            + "…', got '"
                            + line
                            + "'; log:\n"
                            + Files.readString(log));
        return line.substring(start.length());
    }

    /** Ends it as a power cut would: no chance to put anything in order. */
    void kill() throws InterruptedException {
        process.destroyForcibly();
        process.waitFor();
    }

    @Override
    public void close() throws IOException {
        process.destroy();
        try {
            if (!process.waitFor(1, TimeUnit.MINUTES)) process.destroyForcibly();
        } catch (InterruptedException e) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
        Files.deleteIfExists(log);
    }
}
