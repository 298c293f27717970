package rasterlab.tests;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Where the sources under test lie. */
public final class Repository {
    public static final List<String> MODULES =
            List.of("engine", "exercises", "app", "grader", "tests");

    private Repository() {}

    /** The folder that holds {@code settings.gradle.kts}, found upwards from the working folder. */
    public static Path root() {
        for (var folder = Path.of("").toAbsolutePath();
                folder != null;
                folder = folder.getParent()) {
            if (Files.exists(folder.resolve("settings.gradle.kts"))) return folder;
        }
        throw new AssertionError("no settings.gradle.kts above " + Path.of("").toAbsolutePath());
    }

    public static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** All sources with one of the endings, of the modules' main and test trees. */
    public static List<Path> sources(String... endings) {
        try (var files = Files.walk(root())) {
            return files.filter(file -> isSource(root().relativize(file), endings)).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean isSource(Path relative, String... endings) {
        if (relative.getNameCount() < 3 || !relative.getName(1).toString().equals("src"))
            return false;
        for (var ending : endings) if (relative.toString().endsWith(ending)) return true;
        return false;
    }
}
