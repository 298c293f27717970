package rasterlab.exercises.searching;

import java.time.Duration;
import java.util.Optional;
import rasterlab.engine.study.Verdict;
import rasterlab.exercises.scene.MethodCase;

/**
 * An input on which a method fails.
 *
 * @param input as {@code ./lab run} takes it
 * @param seed of the search that found it
 * @param tried how many inputs were tried until it was found
 * @param after how long that took
 */
public record Find(
        String topic,
        String method,
        Verdict verdict,
        String input,
        int seed,
        long tried,
        Duration after) {
    /** The input as a scene file keeps it, with the verdict and the seed. */
    public MethodCase scene() {
        return new MethodCase(
                topic,
                Optional.of(method),
                input,
                Optional.empty(),
                Optional.of(new MethodCase.SearchFinding(verdict.kind().code(), seed)));
    }
}
