package rasterlab.exercises.graded;

import java.util.function.Function;
import rasterlab.engine.study.Topic;

/**
 * Grades any topic whose contract a child can be called by. Its answers are drawn by their form,
 * and a student's speed is held against the exercise's model solution.
 */
public final class AnyGrading<C, I, O> extends ByForm<C, I, O> {
    private final Function<Object, C> whole;

    private AnyGrading(Topic<C, I, O> topic, Class<?> contract, Function<Object, C> whole) {
        super(topic, contract);
        this.whole = whole;
    }

    /** The grading of a topic. */
    public static <C, I, O> AnyGrading<C, I, O> of(Topic<C, I, O> topic) {
        return new AnyGrading<>(topic, topic.contract(), topic.contract()::cast);
    }

    /**
     * The grading of a part of a topic: inputs that a smaller contract is enough for.
     *
     * @param part makes a method of the topic of one that can do the part alone
     */
    @SuppressWarnings("unchecked") // the methods of a topic implement its contract
    public static <C, I, O> AnyGrading<C, I, O> ofPart(Topic<C, I, O> topic, TopicPart<?, ?> part) {
        return new AnyGrading<>(topic, part.contract(), method -> (C) part.whole(method));
    }

    @Override
    protected C whole(Object method) {
        return whole.apply(method);
    }
}
