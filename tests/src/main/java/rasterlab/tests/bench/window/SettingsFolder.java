package rasterlab.tests.bench.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/** A folder for a window's settings; gone when it is closed, and when the program ends before. */
final class SettingsFolder implements AutoCloseable {
    private final Path path;
    private final Thread remover = new Thread(this::abandon, "remove the settings");

    SettingsFolder() throws IOException {
        path = Files.createTempDirectory("rasterlab-window");
        Runtime.getRuntime().addShutdownHook(remover);
    }

    /** Where the window keeps its settings; a second file is made beside it. */
    Path settings() {
        return path.resolve("window.properties");
    }

    @Override
    public void close() throws IOException {
        Runtime.getRuntime().removeShutdownHook(remover);
        remove();
    }

    /** A lab that was started with these settings would make the folder anew. */
    private void abandon() {
        try {
            ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
            remove();
        } catch (IOException e) {
            System.err.println(path + " stays: " + e.getMessage());
        }
    }

    private void remove() throws IOException {
        try (Stream<Path> files = Files.list(path)) {
            for (Path file : files.toList()) Files.deleteIfExists(file);
        }
        Files.delete(path);
    }
}
