package rasterlab.app.cli.exercise;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading;
import rasterlab.exercises.proving.Proof;
import rasterlab.exercises.proving.Proving;

/** Proves exercises beside each other, one on each processor. */
final class ProofPool implements AutoCloseable {
    private final Grading judge;
    private final long seed;
    private final ProofListener progress;
    private final ExecutorService workers;

    /** Hears from several threads that a proof begins. */
    interface ProofListener {
        void begun(Exercise one, int place, int of);
    }

    ProofPool(Grading judge, long seed, ProofListener progress) {
        this.judge = judge;
        this.seed = seed;
        this.progress = progress;
        this.workers = Executors.newFixedThreadPool(Runtime.getRuntime().availableProcessors());
    }

    /** The proofs to come, in the order of the exercises. */
    List<Future<Proof>> proofs(List<Exercise> exercises) {
        List<Future<Proof>> proofs = new ArrayList<>();
        for (Exercise one : exercises) {
            int place = proofs.size() + 1;
            proofs.add(
                    workers.submit(
                            () -> {
                                progress.begun(one, place, exercises.size());
                                return Proving.of(one, seed, judge);
                            }));
        }
        return proofs;
    }

    /** Gives up what has not been proved. */
    @Override
    public void close() {
        workers.shutdownNow();
    }
}
