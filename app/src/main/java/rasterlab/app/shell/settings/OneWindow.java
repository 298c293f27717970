package rasterlab.app.shell.settings;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.function.Consumer;

/** Tells a program that another one keeps its window in the same files. */
public final class OneWindow {
    private OneWindow() {}

    /**
     * Holds the settings until the program ends, or says that another program does.
     *
     * @param settings in whose folder, made where it is missing, {@code window.lock} is made
     * @return whether no other program holds them; one that is not the first writes only what is
     *     changed in its own window
     * @throws IOException if that file cannot be made or locked
     */
    public static boolean hold(Path settings, Consumer<Problem> problem) throws IOException {
        Files.createDirectories(settings.toAbsolutePath().getParent());
        FileChannel channel =
                FileChannel.open(
                        settings.resolveSibling("window.lock"),
                        StandardOpenOption.CREATE,
                        StandardOpenOption.WRITE);
        if (channel.tryLock() == null) {
            channel.close();
            problem.accept(Problem.of("window.second"));
            return false;
        }
        // The hook holds the channel: one that is collected is closed and loses its lock.
        Runtime.getRuntime().addShutdownHook(new Thread(() -> close(channel), "window lock"));
        return true;
    }

    private static void close(FileChannel channel) {
        try {
            channel.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
