package rasterlab.tests;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * A child process run to its end.
 *
 * @param exit the exit status
 * @param out all of stdout
 * @param err all of stderr
 */
public record ChildProcess(int exit, String out, String err) {
    /** Options of a Java that lives for seconds, in which better compiled code only costs time. */
    public static final List<String> SHORT_LIVED =
            List.of("-Xmx400m", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

    /** Runs a command in a folder with changes to the environment (null removes) and no input. */
    public static ChildProcess run(
            Path folder, Map<String, String> environment, Duration limit, List<String> command) {
        var builder = new ProcessBuilder(command).directory(folder.toFile());
        environment.forEach(
                (name, value) -> {
                    if (value == null) builder.environment().remove(name);
                    else builder.environment().put(name, value);
                });
        builder.redirectInput(ProcessBuilder.Redirect.from(nothing()));
        try {
            var process = builder.start();
            var out = CompletableFuture.supplyAsync(() -> text(process.getInputStream()));
            var err = CompletableFuture.supplyAsync(() -> text(process.getErrorStream()));
            if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
                process.descendants().forEach(ProcessHandle::destroyForcibly);
                process.destroyForcibly();
                throw new AssertionError(
                        command + " did not end within " + limit + "\n" + out.join() + err.join());
            }
            return new ChildProcess(process.exitValue(), out.join(), err.join());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError("interrupted while waiting for " + command, e);
        }
    }

    private static File nothing() {
        return new File(File.separatorChar == '\\' ? "NUL" : "/dev/null");
    }

    private static String text(InputStream stream) {
        try (stream) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
