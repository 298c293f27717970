package rasterlab.app.exercise.outcome;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import rasterlab.app.course.LocalTries;
import rasterlab.app.outcome.Complaint;
import rasterlab.exercises.Exercise;

/**
 * The last outcome of each exercise, kept beside its source; files are read and written on a thread
 * of its own. One that cannot be written is lost with the window: a check says it again.
 */
public final class Outcomes implements AutoCloseable {
    private static final int WRITING_SECONDS = 10;

    private final Function<String, Optional<Path>> places;
    private final Executor events;
    private final Map<String, Outcome> known = new HashMap<>();
    private final ExecutorService files =
            Executors.newSingleThreadExecutor(
                    work -> {
                        var thread = new Thread(work, "results");
                        thread.setDaemon(true);
                        return thread;
                    });

    /**
     * @param places where an exercise's outcome is kept; empty for nowhere
     * @param events runs what it is given on the thread that uses this
     */
    public Outcomes(Function<String, Optional<Path>> places, Executor events) {
        this.places = places;
        this.events = events;
    }

    /** The last one of this run, or that of an earlier one once it is read. */
    public Optional<Outcome> of(Exercise exercise) {
        return Optional.ofNullable(known.get(exercise.id()));
    }

    public void keep(Exercise exercise, Outcome outcome) {
        known.put(exercise.id(), outcome);
        places.apply(exercise.id())
                .ifPresent(file -> files.execute(() -> write(file, exercise, outcome)));
    }

    private static void write(Path file, Exercise exercise, Outcome outcome) {
        try {
            OutcomeFile.write(file, exercise, outcome);
            LocalTries.note(file, outcome.points());
        } catch (Complaint unwritable) {
            // The file belongs to an older outcome than the one that is shown.
            file.toFile().delete();
        }
    }

    /**
     * Reads what an earlier run kept, unless this one has another.
     *
     * @param found told, unless there is none or one of this run by then
     */
    public void read(Exercise exercise, Consumer<Outcome> found) {
        if (known.containsKey(exercise.id())) return;
        places.apply(exercise.id())
                .ifPresent(file -> files.execute(() -> read(file, exercise, found)));
    }

    private void read(Path file, Exercise exercise, Consumer<Outcome> found) {
        OutcomeFile.read(file, exercise)
                .ifPresent(outcome -> events.execute(() -> use(exercise, outcome, found)));
    }

    private void use(Exercise exercise, Outcome outcome, Consumer<Outcome> found) {
        if (known.putIfAbsent(exercise.id(), outcome) == null) found.accept(outcome);
    }

    /** Writes what is not written yet. */
    @Override
    public void close() {
        files.shutdown();
        try {
            files.awaitTermination(WRITING_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
