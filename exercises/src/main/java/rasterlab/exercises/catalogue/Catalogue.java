package rasterlab.exercises.catalogue;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.engine.Topics;
import rasterlab.engine.naming.Named;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.score.Phrase;

/**
 * The exercises: those that come with the program, and those in an instructor's own folder, which
 * needs no compiling.
 */
public final class Catalogue {
    private final Map<String, Entry> exercises;
    private final List<String> replaced;

    private Catalogue(Map<String, Entry> exercises, List<String> replaced) {
        this.exercises = exercises;
        this.replaced = List.copyOf(replaced);
    }

    /** An exercise, which is read when it is asked for first. */
    private static final class Entry {
        private final ExerciseFolder folder;
        private Exercise exercise;

        Entry(ExerciseFolder folder) {
            this.folder = folder;
        }

        synchronized Exercise exercise() {
            if (exercise == null) exercise = new ExerciseReader(folder).read();
            return exercise;
        }

        /** Name to content of the files that it is read from. */
        Map<String, byte[]> files() {
            Exercise read = exercise();
            Map<String, byte[]> files = new TreeMap<>(folder.read());
            read.pictures().values().forEach(one -> files.put(one.file(), one.kept()));
            return files;
        }
    }

    /** The exercises that come with the program. */
    public static Catalogue builtIn() {
        Map<String, Entry> exercises = new LinkedHashMap<>();
        for (String id : builtInIds()) exercises.put(id, new Entry(ExerciseFolder.onClassPath(id)));
        return new Catalogue(exercises, List.of());
    }

    /**
     * This catalogue and one exercise for each sub-folder; one of the same id takes the built-in
     * one's place.
     *
     * @throws CatalogueException when a folder cannot be read; names file and field
     */
    public Catalogue withFolder(Path folder) {
        Map<String, Entry> more = new LinkedHashMap<>(exercises);
        List<String> taken = new ArrayList<>(replaced);
        for (Path sub : DiskFiles.subFolders(folder)) {
            Entry entry = new Entry(ExerciseFolder.onDisk(sub));
            CapsCheck.check(entry.folder, entry.exercise());
            String id = entry.exercise().id();
            if (more.put(id, entry) != null) taken.add(id);
        }
        return new Catalogue(more, taken);
    }

    /** The names of built-in exercises whose places those of a folder have taken. */
    public List<String> replaced() {
        return replaced;
    }

    /**
     * The outcome of reading a folder.
     *
     * @param exercise empty where there are faults
     * @param parts what can be looked at also then
     */
    public record FolderReading(
            Optional<Exercise> exercise, List<CatalogueException> faults, FolderParts parts) {}

    /** Reads the folder of one exercise, with all that is wrong in it. */
    public static FolderReading read(Path folder) {
        if (!Files.isDirectory(folder))
            return new FolderReading(
                    Optional.empty(),
                    List.of(
                            new CatalogueException(
                                    folder,
                                    Phrase.of(
                                            Files.exists(folder)
                                                    ? "disk.folder-not"
                                                    : "disk.folder-none"),
                                    null)),
                    FolderParts.NONE);
        return new ExerciseReader(ExerciseFolder.onDisk(folder.toAbsolutePath().normalize()))
                .reading();
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

    /** The names of all exercises, the built-in ones first. */
    public List<String> ids() {
        return List.copyOf(exercises.keySet());
    }

    /**
     * All exercises in the course's order: by topic, and within one first what is written, then
     * what is found.
     */
    public List<Exercise> all() {
        List<String> course = Topics.names();
        return exercises.values().parallelStream()
                .map(Entry::exercise)
                .sorted(
                        Comparator.comparingInt((Exercise one) -> course.indexOf(one.topic()))
                                .thenComparing(Exercise::form))
                .toList();
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
        Entry entry = exercises.get(id);
        if (entry == null)
            throw new IllegalArgumentException(Named.unknown("exercise", id, exercises.keySet()));
        return entry;
    }
}
