package rasterlab.app.exercise;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import rasterlab.app.server.CourseServer;
import rasterlab.exercises.catalogue.Catalogue;

/** A model whose thread of events is the test's own. */
final class Trial implements AutoCloseable {
    private static final long LONGEST_SECONDS = 120;

    private final BlockingQueue<Runnable> events = new LinkedBlockingQueue<>();
    final BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    final ExerciseLabModel model;

    Trial(Path folder) {
        this(folder, Duration.ofMinutes(2));
    }

    /**
     * @param patience with a server
     */
    Trial(Path folder, Duration patience) {
        model =
                new ExerciseLabModel(
                        () -> List.copyOf(Catalogue.builtIn().all()),
                        new CourseServer.ServerTimeouts(patience, patience, patience),
                        events::add,
                        failures::add);
        model.keepIn(folder);
    }

    ExerciseState state() {
        return model.state();
    }

    /** Lets events happen until the state is as wanted. */
    ExerciseState await(String what, Predicate<ExerciseState> wanted) throws InterruptedException {
        while (!wanted.test(model.state())) {
            Runnable event = events.poll(LONGEST_SECONDS, TimeUnit.SECONDS);
            if (event == null) throw new AssertionError(what + ": " + model.state());
            event.run();
        }
        return model.state();
    }

    ExerciseState awaitEnd() throws InterruptedException {
        return await("work ends", state -> !state.work().running());
    }

    @Override
    public void close() {
        model.close();
        if (!failures.isEmpty()) throw new AssertionError("failed", failures.peek());
    }
}
