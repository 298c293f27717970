package rasterlab.exercises.runner;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Starts processes, all from one thread that stays: bubblewrap's --die-with-parent kills the child
 * when the thread that started it ends.
 */
final class Launcher implements AutoCloseable {
    private final Path folder;
    private final ExecutorService thread =
            Executors.newSingleThreadExecutor(Daemons.named("rasterlab-launcher"));

    /**
     * @param folder where processes start
     */
    Launcher(Path folder) {
        this.folder = folder;
    }

    /** Starts a command with an empty environment. */
    Process start(List<String> command) {
        try {
            return thread.submit(() -> spawn(command)).get();
        } catch (ExecutionException e) {
            throw new UncheckedIOException(
                    "cannot start " + command.get(0),
                    e.getCause() instanceof IOException io ? io : new IOException(e.getCause()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while starting a child", e);
        }
    }

    private Process spawn(List<String> command) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
        String windows = System.getenv("SystemRoot");
        builder.environment().clear();
        if (windows != null) builder.environment().put("SystemRoot", windows);
        return builder.start();
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
