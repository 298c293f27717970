package rasterlab.exercises.pixels;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.TopicGrading.TimedAnswers;
import rasterlab.exercises.TopicGrading.TimingInputs;
import rasterlab.exercises.judging.TimedInput;

/**
 * Inputs in several parts, and what the pixels of their right answers sum up to.
 *
 * <p>The rule by which a method is timed although it has a mistake: in each part the answers must
 * be right, or all be wrong in one way that is known ({@link PixelVariation}) and that lost its
 * points in a case already; whoever draws every pixel twice is timed with that work. What is wrong
 * otherwise is not timed, and neither is a table, a constant or nothing, which do not get so far:
 * the accuracy asked for first is out of their reach.
 */
final class SummedBatch<C, I> implements TimingInputs {
    private final Topic<C, I, PixelRecording> topic;
    private final C plain;
    private final List<TimedInput<I>> inputs;
    private final PixelVariation.Likely likely;
    private final List<PixelRecording> drawn;
    private final int[] part;
    private final int longest;
    private final PartSums right;

    /**
     * @param plain a right method
     * @param likely the variation that explained the answers before
     */
    SummedBatch(
            Topic<C, I, PixelRecording> topic,
            C plain,
            List<TimedInput<I>> inputs,
            PixelVariation.Likely likely) {
        this.topic = topic;
        this.plain = plain;
        this.inputs = inputs;
        this.likely = likely;
        this.part = inputs.stream().mapToInt(TimedInput::part).toArray();
        this.drawn =
                inputs.stream()
                        .map(one -> topic.record(plain, one.input(), topic.mostItems()))
                        .toList();
        this.longest = drawn.stream().mapToInt(PixelRecording::size).max().orElse(0);
        this.right = sums(PixelVariation.RIGHT);
    }

    private PartSums sums(PixelVariation variation) {
        int parts = 1 + inputs.stream().mapToInt(TimedInput::part).max().orElse(0);
        return PartSums.of(drawn, part, parts, variation);
    }

    @Override
    public int inputs() {
        return inputs.size();
    }

    @Override
    @SuppressWarnings("unchecked") // the caller has it from this topic's contract
    public Object recorded(int input, Object method) {
        return topic.record((C) method, inputs.get(input).input(), mostItems());
    }

    @Override
    @SuppressWarnings("unchecked") // the caller has it from this topic's contract
    public long spent(int input, Object method) {
        return topic.spend((C) method, inputs.get(input).input());
    }

    @Override
    public int mostItems() {
        return (int) topic.mostBeforeEndless(longest);
    }

    @Override
    public int usualItems() {
        return longest;
    }

    /** The items that were looked at; none, since the sums of all tell enough. */
    @Override
    public OptionalInt looked() {
        return OptionalInt.empty();
    }

    @Override
    public Object right() {
        return plain;
    }

    @Override
    public long count() {
        return right.count();
    }

    @Override
    public Optional<Set<String>> mistakes(TimedAnswers told) {
        long count = told.count();
        long sum = told.sum();
        if (count == right.count() && sum == right.sum()) return Optional.of(Set.of());
        return likely.first(one -> sums(one).mixedWith(right, count, sum))
                .map(PixelVariation::codes);
    }
}
