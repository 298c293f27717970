package rasterlab.exercises.runner;

import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.runner.process.ChildLost;
import rasterlab.exercises.runner.process.Daemons;

/**
 * Calls of the reference in a fresh child, made while the student's method is called: both at the
 * same time where there are two processors.
 */
final class CallsBeside implements AutoCloseable {
    /** A time far longer than an interrupted call takes. */
    private static final int PATIENCE_SECONDS = 60;

    private final ExecutorService thread =
            Executors.newSingleThreadExecutor(Daemons.named("rasterlab-pace"));
    private final Student reference;
    private final int count;
    private final Future<Void> calls;

    CallsBeside(Student reference, List<GradedCall> calls) {
        this.reference = reference;
        this.count = calls.size();
        this.calls = thread.submit(() -> make(reference, calls));
    }

    Student reference() {
        return reference;
    }

    /**
     * Whether the children of both, as they are, have answered just these calls; waits until all
     * are made.
     *
     * @throws ChildLost when the reference's child was lost, which no student can help
     */
    boolean areOf(Student student) throws ChildLost, InterruptedException {
        await();
        return student.answered() == count && reference.answered() == count;
    }

    /** Has them answered by a fresh child. */
    static Void make(Student one, List<GradedCall> calls) throws ChildLost, InterruptedException {
        one.beginAnew();
        for (GradedCall call : calls) one.call(call);
        return null;
    }

    /**
     * Waits until all are made.
     *
     * @throws ChildLost when the child was lost, which no student can help
     */
    void await() throws ChildLost, InterruptedException {
        try {
            calls.get();
        } catch (ExecutionException failed) {
            Throwable cause = failed.getCause();
            if (cause instanceof ChildLost lost) throw lost;
            if (cause instanceof InterruptedException interrupted) throw interrupted;
            if (cause instanceof RuntimeException cannotStart) throw cannotStart;
            throw new IllegalStateException("the reference cannot be called", cause);
        }
    }

    /** Makes no further call; whoever closes this has the reference to itself again. */
    @Override
    public void close() {
        thread.shutdownNow();
        try {
            if (!thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS))
                throw new IllegalStateException("a call of the reference does not end");
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
