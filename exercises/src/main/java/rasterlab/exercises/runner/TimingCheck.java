package rasterlab.exercises.runner;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.TimingInputs;
import rasterlab.exercises.child.ContractCalls;
import rasterlab.exercises.child.MeasuredMethod;
import rasterlab.exercises.child.Wire;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Holds what an exercise has methods timed on against what a child takes and answers at once: where
 * it is more, nobody's speed can be measured.
 */
public final class TimingCheck {
    private static final long SEED = 1;

    /** Batches are drawn; one may be smaller than most. */
    private static final int BATCHES = 3;

    private final Exercise exercise;
    private final ContractCalls contract;
    private final TopicGrading.Timings timings;

    private TimingCheck(Exercise exercise) {
        this.exercise = exercise;
        TopicGrading topic = TopicGradings.of(exercise);
        this.contract = ContractCalls.of(topic.contract());
        this.timings = topic.timings(exercise, new Random(SEED), List.of());
    }

    /**
     * Why speed cannot be measured; empty where it can, or earns nothing.
     *
     * @param exercise that asks for a program
     * @param file in which its inputs stand
     */
    public static Optional<Phrase> fault(Exercise exercise, String file) {
        if (exercise.points().speed() == 0) return Optional.empty();
        TimingCheck check = new TimingCheck(exercise);
        Optional<Phrase> fault = Optional.empty();
        for (int left = BATCHES; left > 0 && fault.isEmpty(); left--) fault = check.next();
        return fault.map(reason -> at(file, reason));
    }

    /** A fault of the field that says what is timed. */
    public static Phrase at(String file, Phrase reason) {
        return Phrase.of("folder.at", Phrase.of("field", file, "timed"), reason);
    }

    private Optional<Phrase> next() {
        TimingInputs timing = timings.next();
        int asked;
        try {
            asked = new TimedBatch(contract, timing, exercise.caps()).request().frame(0).length;
        } catch (LimitReached beyond) {
            return Optional.of(Phrase.of("timed.items", timing.mostItems()));
        } catch (IllegalArgumentException refused) {
            return Optional.of(Phrase.of("timed.refused", refused.getMessage()));
        }
        if (asked > Wire.MOST_FRAME_BYTES)
            return Optional.of(Phrase.of("timed.inputs", asked, Wire.MOST_FRAME_BYTES));
        if (timing.looked().isEmpty()) return Optional.empty();
        int most = exercise.caps().bytes().orElse(Wire.MOST_ANSWER_BYTES);
        long least = answer(timing, timing.looked().getAsInt());
        return least > most
                ? Optional.of(Phrase.of("timed.answer", least, most))
                : Optional.empty();
    }

    /** Bytes of the right answer to an input that is looked at. */
    private long answer(TimingInputs timing, int input) {
        var right = new MeasuredMethod(contract, timing.right(), timing.mostItems());
        try {
            timing.recorded(input, right.proxy());
            return right.all();
        } catch (LimitReached | IllegalArgumentException cutOrRefused) {
            return right.all();
        }
    }
}
