package rasterlab.app.shell;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Consumer;

/** Tells a program that another one keeps its window in the same files. */
public final class OneWindow {
    private OneWindow() {}

    /**
     * Holds the settings until the program ends, or says that another program does.
     *
     * @param settings in whose folder, which must be there, {@code window.lock} is made
     * @throws IOException if that file cannot be made or locked
     */
    public static void hold(Path settings, Consumer<Problem> problem) throws IOException {
        FileChannel channel =
                FileChannel.open(
                        settings.resolveSibling("window.lock"),
                        StandardOpenOption.CREATE,
                        StandardOpenOption.WRITE);
        if (channel.tryLock() == null) {
            channel.close();
            problem.accept(Problem.of("window.second"));
            return;
        }
        // A channel that nothing holds is closed with its lock some day.
        Runtime.getRuntime().addShutdownHook(new Thread(() -> close(channel), "window lock"));
    }

    private static void close(FileChannel channel) {
        try {
            channel.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
