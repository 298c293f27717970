package rasterlab.exercises.catalogue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;

/**
 * The exercises: those that come with the program, and those in an instructor's own folder, which
 * needs no compiling.
 */
public final class Catalogue {
    private final Map<String, Supplier<Entry>> exercises;

    private Catalogue(Map<String, Supplier<Entry>> exercises) {
        this.exercises = exercises;
    }

    /** An exercise and the files that it was read from. */
    private record Entry(Exercise exercise, Map<String, byte[]> files) {}

    /** Reads an exercise when it is asked for, and once: whoever wants one need not read all. */
    private static final class Later implements Supplier<Entry> {
        private final String id;
        private Entry read;

        Later(String id) {
            this.id = id;
        }

        @Override
        public synchronized Entry get() {
            if (read == null) read = read(ExerciseFolder.onClassPath(id));
            return read;
        }
    }

    /** The exercises that come with the program. */
    public static Catalogue builtIn() {
        Map<String, Supplier<Entry>> exercises = new LinkedHashMap<>();
        for (String id : builtInIds()) exercises.put(id, new Later(id));
        return new Catalogue(exercises);
    }

    /**
     * This catalogue and one exercise for each sub-folder; one of the same id takes the built-in
     * one's place.
     *
     * @throws CatalogueException when a folder cannot be read; names file and field
     */
    public Catalogue withFolder(Path folder) {
        Map<String, Supplier<Entry>> more = new LinkedHashMap<>(exercises);
        for (Path sub : DiskFiles.subFolders(folder)) {
            Entry entry = read(ExerciseFolder.onDisk(sub));
            more.put(entry.exercise().id(), () -> entry);
        }
        return new Catalogue(more);
    }

    private static Entry read(ExerciseFolder folder) {
        Exercise exercise = new ExerciseReader(folder).read();
        Map<String, byte[]> files = new TreeMap<>(folder.read());
        exercise.pictures().forEach((name, picture) -> files.put(name, picture.content()));
        return new Entry(exercise, files);
    }

    /**
     * An exercise from files that were kept, as {@link #files} gave them.
     *
     * @throws CatalogueException when this version does not read them; names file and field
     */
    public static Exercise kept(String id, Map<String, byte[]> files) {
        return new ExerciseReader(ExerciseFolder.kept(id, files)).read();
    }

    /** Name to content of everything that the exercise of that id was read from. */
    public Map<String, byte[]> files(String id) {
        return entry(id).files();
    }

    private static List<String> builtInIds() {
        try (InputStream in =
                Catalogue.class.getResourceAsStream("/rasterlab/exercises/built-in.txt")) {
            return new ArrayList<>(
                    new String(in.readAllBytes(), StandardCharsets.UTF_8)
                            .lines()
                            .filter(line -> !line.isBlank())
                            .toList());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** All exercises, the built-in ones first. */
    public List<Exercise> all() {
        return exercises.values().stream().map(Supplier::get).map(Entry::exercise).toList();
    }

    /**
     * The exercise of that id.
     *
     * @throws IllegalArgumentException when there is none; names those there are
     */
    public Exercise named(String id) {
        return entry(id).exercise();
    }

    private Entry entry(String id) {
        Supplier<Entry> entry = exercises.get(id);
        if (entry == null)
            throw new IllegalArgumentException(
                    "no exercise called '"
                            + id
                            + "'; there are "
                            + String.join(", ", exercises.keySet()));
        return entry.get();
    }
}
