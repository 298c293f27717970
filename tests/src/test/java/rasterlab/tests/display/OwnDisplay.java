package rasterlab.tests.display;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/**
 * Lets the tests of a class open windows while no other process of tests does so on the same
 * display, which has one keyboard and one mouse.
 */
public final class OwnDisplay implements BeforeAllCallback {
    private static final Namespace NAMESPACE = Namespace.create(OwnDisplay.class);

    @Override
    public void beforeAll(ExtensionContext context) {
        if (GraphicsEnvironment.isHeadless()) return;
        context.getStore(NAMESPACE).getOrComputeIfAbsent(Turn.class, type -> Turn.await(file()));
    }

    /** One for each display; they stay, for whoever removed one could let two have their turn. */
    static Path file() {
        String display = System.getenv().getOrDefault("DISPLAY", "").replaceAll("\\W", "_");
        return Path.of(System.getProperty("java.io.tmpdir"), "rasterlab-tests-display" + display);
    }

    /** Ends with the class, or with the process. */
    private record Turn(FileChannel channel, FileLock lock) implements AutoCloseable {
        static Turn await(Path file) {
            try {
                var channel =
                        FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
                return new Turn(channel, channel.lock());
            } catch (IOException e) {
                throw new java.io.UncheckedIOException("cannot lock " + file, e);
            }
        }

        @Override
        public void close() throws IOException {
            DisplayAtRest.await(); // This class may be the last.
            channel.close();
        }
    }
}
