package rasterlab.exercises.judging;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.score.CasePicture;
import rasterlab.exercises.score.Phrase;

/**
 * Grades any topic by its own exact answer, its own comparison, and its own faulty methods and
 * mutants. A topic adds what a student's speed is held against and how its answers are drawn.
 *
 * @param <C> the contract
 * @param <I> one input
 * @param <O> one output
 */
public abstract class ByTopic<C, I, O> implements TopicGrading {
    private final Topic<C, I, O> topic;
    private final Class<C> contract;
    private final C reference;

    /**
     * @param reference a right method, as plain as a student writes it; its class has a constructor
     *     without parameters and needs no other class but those of its package
     */
    protected ByTopic(Topic<C, I, O> topic, Class<C> contract, C reference) {
        this.topic = topic;
        this.contract = contract;
        this.reference = reference;
    }

    /**
     * Draws what is expected and what came.
     *
     * @param exact the right answer
     * @param actual an answer that is not right
     */
    protected abstract List<CasePicture> pictures(I input, O exact, O actual);

    @Override
    public final String name() {
        return topic.name();
    }

    @Override
    public final Class<?> contract() {
        return contract;
    }

    @Override
    public final Class<?> reference() {
        return reference.getClass();
    }

    @Override
    public final Optional<String> unit() {
        return Optional.of(topic.errorUnit());
    }

    @Override
    public final List<Call> calls(Case one, Tolerance tolerance, long seed) {
        TopicInputs.Read<I> read = new TopicInputs<>(topic).of(one, seed);
        return read.inputs().stream()
                .<Call>map(input -> new InputCall<>(this, input, tolerance, read.mayRefuse()))
                .toList();
    }

    @Override
    public final Set<String> mistakes() {
        Set<String> codes = new TreeSet<>();
        topic.methods().stream().filter(Method::faulty).forEach(one -> codes.add(one.name()));
        topic.mutants().forEach(one -> codes.add(one.name()));
        return codes;
    }

    @Override
    public final Timings timings(
            Exercise exercise, Random random, Collection<Set<String>> wrongOn) {
        String data =
                exercise.timed()
                        .orElseThrow(
                                () ->
                                        new CatalogueException(
                                                Phrase.of(
                                                        "field.wrong",
                                                        Phrase.quoted("timed"),
                                                        Phrase.of("field.missing"))));
        TopicInputs<C, I> inputs = new TopicInputs<>(topic);
        Phrase place = Phrase.quoted("timed");
        inputs.drawn(place, data, random, 1);
        return () ->
                new InputBatch<>(
                        this, inputs.drawn(place, data, random), exercise.tolerance(), random);
    }

    Topic<C, I, O> topic() {
        return topic;
    }

    C right() {
        return reference;
    }

    /** The exact answer, of a very long one its beginning. */
    O exact(I input) {
        return topic.exact(input, topic.mostItems());
    }

    /** Whether an output is right for that input. */
    boolean isRight(I input, O exact, O actual, Tolerance tolerance) {
        var deviation = topic.compare(input, exact, actual);
        boolean within =
                tolerance.worst().isPresent()
                        && deviation.missing() == 0
                        && deviation.extra() == 0
                        && deviation.worst() <= tolerance.worst().getAsDouble();
        return within || topic.correct(deviation);
    }
}
