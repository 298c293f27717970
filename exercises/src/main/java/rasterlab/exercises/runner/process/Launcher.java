package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * Starts processes, all from one thread that stays: bubblewrap's --die-with-parent kills the child
 * when the thread that started it ends.
 */
public final class Launcher implements AutoCloseable {
    private final ChildJars jars;
    private final ExecutorService thread =
            Executors.newSingleThreadExecutor(Daemons.named("rasterlab-launcher"));

    /**
     * @param jars in whose folder processes start
     */
    public Launcher(ChildJars jars) {
        this.jars = jars;
    }

    /**
     * Starts a command with an empty environment.
     *
     * @throws UncheckedIOException when it cannot be started
     */
    public Process start(List<String> command) {
        try {
            // join, unlike get, is not left by an interrupt: no started process gets lost
            return CompletableFuture.supplyAsync(() -> spawn(command), thread).join();
        } catch (CompletionException e) {
            if (e.getCause() instanceof UncheckedIOException io) throw io;
            throw e;
        }
    }

    private Process spawn(List<String> command) {
        ProcessBuilder builder = new ProcessBuilder(command).directory(jars.folder().toFile());
        String windows = System.getenv("SystemRoot");
        builder.environment().clear();
        if (windows != null) builder.environment().put("SystemRoot", windows);
        try {
            return builder.start();
        } catch (IOException e) {
            throw new UncheckedIOException("cannot start " + command.get(0), e);
        }
    }

    @Override
    public void close() {
        thread.shutdownNow();
    }
}
