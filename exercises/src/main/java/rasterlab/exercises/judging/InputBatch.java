package rasterlab.exercises.judging;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading.TimedAnswers;
import rasterlab.exercises.TopicGrading.TimingInputs;

/**
 * Inputs to time a method on. The answer to one of them, drawn at random, is judged like that of a
 * case.
 */
final class InputBatch<C, I, O> implements TimingInputs {
    private final ByTopic<C, I, O> grading;
    private final List<I> inputs;
    private final ExerciseTolerance tolerance;
    private final int looked;
    private final long count;

    InputBatch(
            ByTopic<C, I, O> grading, List<I> inputs, ExerciseTolerance tolerance, Random random) {
        this.grading = grading;
        this.inputs = inputs;
        this.tolerance = tolerance;
        this.looked = random.nextInt(inputs.size());
        this.count =
                inputs.stream()
                        .mapToLong(input -> grading.topic().spend(grading.plain(), input))
                        .sum();
    }

    @Override
    public int inputs() {
        return inputs.size();
    }

    @Override
    public Object recorded(int input, Object method) {
        return grading.topic().record(grading.whole(method), inputs.get(input), mostItems());
    }

    @Override
    public long spent(int input, Object method) {
        return grading.topic().spend(grading.whole(method), inputs.get(input));
    }

    @Override
    public int mostItems() {
        return grading.topic().mostItems();
    }

    @Override
    public int usualItems() {
        return 1;
    }

    @Override
    public OptionalInt looked() {
        return OptionalInt.of(looked);
    }

    @Override
    public Object right() {
        return grading.plain();
    }

    @Override
    public long count() {
        return count;
    }

    @Override
    @SuppressWarnings("unchecked") // recorded by this class
    public Optional<Set<String>> mistakes(TimedAnswers told) {
        I input = inputs.get(looked);
        O exact = grading.truth(input, tolerance, mostItems());
        return told.looked()
                .filter(output -> grading.isRight(input, exact, (O) output, tolerance))
                .map(right -> Set.of());
    }
}
