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
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;

/**
 * The exercises: those that come with the program, and those in an instructor's own folder, which
 * needs no compiling.
 */
public final class Catalogue {
    private final Map<String, Exercise> exercises;

    private Catalogue(Map<String, Exercise> exercises) {
        this.exercises = exercises;
    }

    /** The exercises that come with the program. */
    public static Catalogue builtIn() {
        Map<String, Exercise> exercises = new LinkedHashMap<>();
        for (String id : builtInIds()) add(exercises, ExerciseFolder.onClassPath(id));
        return new Catalogue(exercises);
    }

    /**
     * This catalogue and one exercise for each sub-folder; one of the same id takes the built-in
     * one's place.
     *
     * @throws CatalogueException when a folder cannot be read; names file and field
     */
    public Catalogue withFolder(Path folder) {
        Map<String, Exercise> more = new LinkedHashMap<>(exercises);
        for (Path sub : DiskFiles.subFolders(folder)) add(more, ExerciseFolder.onDisk(sub));
        return new Catalogue(more);
    }

    private static void add(Map<String, Exercise> exercises, ExerciseFolder folder) {
        Exercise exercise = new ExerciseReader(folder).read();
        exercises.put(exercise.id(), exercise);
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
        return List.copyOf(exercises.values());
    }

    /**
     * The exercise of that id.
     *
     * @throws IllegalArgumentException when there is none; names those there are
     */
    public Exercise named(String id) {
        Exercise exercise = exercises.get(id);
        if (exercise == null)
            throw new IllegalArgumentException(
                    "no exercise called '"
                            + id
                            + "'; there are "
                            + String.join(", ", exercises.keySet()));
        return exercise;
    }
}
