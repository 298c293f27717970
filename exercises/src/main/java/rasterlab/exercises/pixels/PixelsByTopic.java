package rasterlab.exercises.pixels;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.Supplier;
import rasterlab.engine.raster.FirstDifference;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.drawing.PixelPictures;
import rasterlab.exercises.judging.ByTopic;
import rasterlab.exercises.judging.Demand;
import rasterlab.exercises.judging.DifferingItem;
import rasterlab.exercises.judging.TimedInput;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Cause;
import rasterlab.exercises.score.Finding;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Message;

/**
 * Grades topics whose answers are pixels from one end to the other: each once, in their order.
 *
 * @param <C> the contract
 * @param <I> one input
 */
public abstract class PixelsByTopic<C, I> extends ByTopic<C, I, PixelRecording> {
    /**
     * @param plain a right method, as plain as a student writes it
     */
    protected PixelsByTopic(Topic<C, I, PixelRecording> topic, C plain) {
        super(topic, plain);
    }

    protected abstract PixelPath path(I input);

    /** {@inheritDoc} None: pixels are right or wrong. */
    @Override
    public final Optional<String> unit() {
        return Optional.empty();
    }

    @Override
    public final String inOwnWords(String key) {
        return key;
    }

    @Override
    public final List<String> truths() {
        return List.of();
    }

    @Override
    protected final boolean isInOrder() {
        return true;
    }

    @Override
    protected final PixelRecording right(
            I input, Supplier<PixelRecording> truth, PixelRecording actual, Demand demand) {
        return right(input, actual, demand, demand.items());
    }

    private PixelRecording right(I input, PixelRecording actual, Demand demand, int limit) {
        PixelPath path = path(input);
        return demand.tolerance().eitherPixelOnTies()
                ? path.nearest(actual, limit)
                : path.exact(limit);
    }

    @Override
    protected final boolean isRight(
            I input, PixelRecording exact, PixelRecording actual, ExerciseTolerance tolerance) {
        return isSame(exact, actual);
    }

    @Override
    protected final Predicate<PixelRecording> sameAs(I input, PixelRecording actual) {
        return known -> isSame(known, actual);
    }

    private static boolean isSame(PixelRecording one, PixelRecording other) {
        if (one.size() != other.size()) return false;
        for (int i = 0; i < one.size(); i++)
            if (one.x(i) != other.x(i) || one.y(i) != other.y(i)) return false;
        return true;
    }

    @Override
    protected final Set<String> ownMistakes() {
        return PixelMistakes.CODES;
    }

    @Override
    protected final List<List<Cause>> explanations(I input, PixelRecording actual, Demand demand) {
        return new PixelMistakes(
                        path(input),
                        demand.items(),
                        demand.cut(),
                        demand.tolerance().eitherPixelOnTies())
                .of(actual);
    }

    @Override
    protected final String knownMethod() {
        return "known-fault.told";
    }

    /** {@inheritDoc} Of a cut line, no pixel is missing where all that is wrong comes twice. */
    @Override
    protected final PixelRecording shownRight(
            I input,
            PixelRecording right,
            PixelRecording actual,
            Demand demand,
            List<List<Cause>> causes) {
        boolean again = causes.stream().anyMatch(one -> Cause.codes(one).equals(List.of("again")));
        return demand.cut() && again
                ? right(input, actual, demand, PixelSet.of(actual).size())
                : right;
    }

    @Override
    protected final Message difference(I input, PixelRecording right, PixelRecording actual) {
        FirstDifference first = FirstDifference.of(right, actual).orElseThrow();
        return first.drawn()
                .map(drawn -> Message.of("pixel.instead", first.pixel(), drawn))
                .orElseGet(
                        () -> {
                            String kind = first.kind().name().toLowerCase(Locale.ROOT);
                            return Message.of("pixel." + kind, first.pixel());
                        });
    }

    @Override
    protected final Optional<DifferingItem> differing(
            I input, PixelRecording right, PixelRecording actual, Message said) {
        return FirstDifference.of(right, actual).map(first -> DifferingItem.at(first.pixel()));
    }

    /** {@inheritDoc} The first faulty method that draws the very same. */
    @Override
    protected final Optional<String> further(I input, PixelRecording actual, Demand demand) {
        for (Method<C> method : topic().methods())
            if (method.faulty() && isSame(drawnBy(method.implementation(), input, demand), actual))
                return Optional.of(method.name());
        return Optional.empty();
    }

    private PixelRecording drawnBy(C method, I input, Demand demand) {
        long most = topic().mostBeforeEndless(demand.items());
        try {
            return topic().record(method, input, demand.cut() ? demand.items() : (int) most);
        } catch (LimitReached reached) {
            return (PixelRecording) reached.recorded();
        }
    }

    @Override
    protected final Finding endless(I input, Answer answer, Demand demand, boolean whole) {
        PixelRecording actual = (PixelRecording) answer.output().orElseThrow();
        PixelRecording right = right(input, actual, demand, demand.items());
        return new Finding(
                GradingVerdict.OUTPUT_LIMIT,
                Message.of("still-plotting", actual.size(), right.size()),
                whole ? pictures(input, right, actual) : List.of(),
                List.of(List.of(Cause.of("endless"))));
    }

    @Override
    protected final List<CasePicture> pictures(
            I input, PixelRecording right, PixelRecording actual) {
        PixelDifference difference = PixelDifference.of(right, actual);
        PixelSet misplaced = PixelSet.of(new PixelOrder(right, actual).misplaced(difference));
        return FirstDifference.of(right, actual)
                .map(
                        first ->
                                PixelPictures.of(
                                        difference,
                                        misplaced.filter(difference.right()::contains),
                                        first.pixel()))
                .orElse(List.of());
    }

    @Override
    protected final Optional<MethodCase.DrawnPixels> drawn(Answer answer) {
        boolean cut = answer.ending() == Answer.CallEnding.CUT;
        return answer.output()
                .map(
                        output ->
                                MethodCase.DrawnPixels.of(
                                        new Plotted((PixelRecording) output, cut)));
    }

    @Override
    protected final Timings timings(
            Supplier<List<TimedInput<I>>> inputs, ExerciseTolerance tolerance, Random random) {
        PixelVariation.Likely likely = new PixelVariation.Likely();
        return () -> new SummedBatch<>(topic(), plain(), inputs.get(), likely);
    }
}
