package rasterlab.app.found;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.scene.MethodCase;

/**
 * The inputs that a search found and the user keeps, each a scene file that {@code ./lab run
 * --scene} and exercises take too, named {@code TOPIC.METHOD.1.scene.json}, …
 */
public final class FoundHazards {
    /** The most kept for one method, all of which are chips of one row. */
    static final int MOST = 20;

    private final Path folder;

    /**
     * A kept find.
     *
     * @param name of its file without the ending
     */
    public record KeptFind(String name, MethodCase scene, Path file) {}

    private FoundHazards(Path folder) {
        this.folder = folder;
    }

    /** The finds in the usual place beside the settings of the user. */
    public static FoundHazards in(Path settings) {
        return new FoundHazards(settings.resolve("hazards"));
    }

    /**
     * Passes if finds can be kept, before one is searched for.
     *
     * @throws Complaint saying what is in the way
     */
    public void requireWritable() {
        WholeFile.requireFolderWritable(folder);
    }

    /**
     * Keeps a find; one with the same topic, method and input is kept once.
     *
     * @return its file
     * @throws Complaint if it cannot be written or the method has {@link #MOST} already
     */
    public Path keep(MethodCase scene) {
        String method = scene.method().orElse("own");
        List<KeptFind> others = of(scene.topic());
        for (KeptFind each : others)
            if (each.scene().method().equals(scene.method())
                    && each.scene().input().equals(scene.input())) return each.file();
        WholeFile.requireFolder(folder);
        for (int number = 1; number <= MOST; number++) {
            String name = scene.topic() + "." + method + "." + number;
            Path file = folder.resolve(name + SceneText.EXTENSION);
            if (Files.exists(file)) continue;
            WholeFile.write(file, (scene.write() + "\n").getBytes(StandardCharsets.UTF_8));
            return file;
        }
        throw Complaint.badInput(
                "%s: has %d hazards of %s already; remove one".formatted(folder, MOST, method));
    }

    /** The finds of a topic, by name; what is no such file is left where it is. */
    public List<KeptFind> of(String topic) {
        if (!Files.isDirectory(folder)) return List.of();
        try (Stream<Path> files = Files.list(folder)) {
            return files.sorted()
                    .filter(file -> name(file).startsWith(topic + "."))
                    .flatMap(file -> read(file).stream())
                    .filter(each -> each.scene().topic().equals(topic))
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static String name(Path file) {
        return file.getFileName().toString();
    }

    private static Optional<KeptFind> read(Path file) {
        if (!name(file).endsWith(SceneText.EXTENSION)) return Optional.empty();
        try {
            String stem =
                    name(file).substring(0, name(file).length() - SceneText.EXTENSION.length());
            return Optional.of(new KeptFind(stem, SceneText.methodCase(file), file));
        } catch (Complaint noCase) {
            // ./lab run --scene FILE says what is wrong with it
            return Optional.empty();
        }
    }

    /**
     * Removes a find.
     *
     * @throws UncheckedIOException if its file cannot be removed
     */
    public void remove(KeptFind find) {
        try {
            Files.deleteIfExists(find.file());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
