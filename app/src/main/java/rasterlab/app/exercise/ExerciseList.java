package rasterlab.app.exercise;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Supplier;
import rasterlab.exercises.Exercise;

/** The exercises, read by the thread that asks first. */
final class ExerciseList {
    private final Supplier<List<Exercise>> catalogue;
    private Optional<List<Exercise>> read = Optional.empty();

    ExerciseList(Supplier<List<Exercise>> catalogue) {
        this.catalogue = catalogue;
    }

    /**
     * Begins to read them in the background, so that who asks next waits less. What fails there
     * fails again, and is told, where they are asked for.
     */
    void readAhead() {
        CompletableFuture.runAsync(this::get, ExerciseList::inBackground);
    }

    private static void inBackground(Runnable reading) {
        var thread = new Thread(reading, "exercises");
        thread.setDaemon(true);
        thread.start();
    }

    synchronized List<Exercise> get() {
        if (read.isEmpty()) read = Optional.of(catalogue.get());
        return read.get();
    }

    /** Has an exercise in the place of the one of its name, or behind all. */
    synchronized void put(Exercise exercise) {
        if (get().contains(exercise)) return;
        var all = new ArrayList<>(get());
        all.replaceAll(one -> one.id().equals(exercise.id()) ? exercise : one);
        if (!all.contains(exercise)) all.add(exercise);
        read = Optional.of(List.copyOf(all));
    }

    Exercise namedOrFirst(String id) {
        return get().stream().filter(one -> one.id().equals(id)).findFirst().orElse(get().get(0));
    }

    /** The ending of the names of files that are handed in for it, without the dot. */
    String ending(String id) {
        return namedOrFirst(id).form().ending();
    }
}
