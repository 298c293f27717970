package rasterlab.app.row;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Verdict;

/**
 * How a topic's inputs and outputs look as rows.
 *
 * @param <C> contract of the topic's methods
 * @param <I> its input
 * @param <O> its output
 */
abstract class RowKind<C, I, O> {
    private final Topic<C, I, O> topic;
    private final Map<String, Right<I, O>> rights = new ConcurrentHashMap<>();

    /** The right answer, which takes much longer than any method's. */
    private record Right<I, O>(Hazard<I> hazard, O exact) {}

    RowKind(Topic<C, I, O> topic) {
        this.topic = topic;
    }

    final Topic<C, I, O> topic() {
        return topic;
    }

    abstract int pixels(I input);

    abstract List<RowScene.Band> right(I input, O exact);

    abstract List<RowScene.Band> made(I input, O actual);

    /** In the topic's unit. */
    abstract double error(I input, O exact, O actual, int pixel);

    abstract boolean wrong(I input, O exact, O actual, int pixel);

    abstract RowScene.Numbers numbers(I input, O exact, Optional<O> actual, int pixel);

    Optional<RowScene.Image> image(I input) {
        return Optional.empty();
    }

    /**
     * @throws IllegalArgumentException if there is no such hazard or method
     */
    final RowScene scene(RowChoice choice) {
        Right<I, O> right = right(choice.hazard());
        C method = topic.method(choice.method()).implementation();
        I input = right.hazard().input();
        try {
            return scene(right, topic.record(method, input, Integer.MAX_VALUE));
        } catch (IllegalArgumentException refusal) {
            return refused(right, refusal.getMessage());
        }
    }

    final int pixels(String hazard) {
        return pixels(hazard(hazard).input());
    }

    private Hazard<I> hazard(String name) {
        return Named.find("hazard", name, topic.hazards(), Hazard::name);
    }

    /**
     * @throws IllegalArgumentException if there is no such hazard, method or pixel
     */
    final void require(RowChoice choice) {
        topic.method(choice.method());
        int pixels = pixels(choice.hazard());
        if (choice.pixel() < 0 || choice.pixel() >= pixels)
            throw new IllegalArgumentException(
                    "pixel must be from 0 to %d, got %d".formatted(pixels - 1, choice.pixel()));
    }

    private Right<I, O> right(String name) {
        return rights.computeIfAbsent(
                name,
                key -> {
                    Hazard<I> hazard = hazard(key);
                    return new Right<>(hazard, topic.exact(hazard.input(), Integer.MAX_VALUE));
                });
    }

    /** Finds the right answer, so that {@link #scene} is quick; on any thread. */
    final void prepare(String hazard) {
        right(hazard);
    }

    private RowScene scene(Right<I, O> right, O actual) {
        I input = right.hazard().input();
        O exact = right.exact();
        var bands = new ArrayList<>(right(input, exact));
        bands.addAll(made(input, actual));
        int pixels = bands.get(0).argb().length;
        var wrong = new boolean[pixels];
        var errors = new double[pixels];
        for (int i = 0; i < pixels; i++) {
            wrong[i] = wrong(input, exact, actual, i);
            errors[i] = error(input, exact, actual, i);
        }
        return new RowScene(
                bands,
                wrong,
                errors,
                verdict(topic.compare(input, exact, actual)),
                pixel -> numbers(input, exact, Optional.of(actual), pixel),
                image(input));
    }

    private Verdict verdict(Deviation deviation) {
        Verdict.Kind kind =
                topic.correct(deviation)
                        ? Verdict.Kind.EXACT
                        : topic.usable(deviation) ? Verdict.Kind.DEGRADED : Verdict.Kind.WRONG;
        return new Verdict(kind, deviation, deviation.first());
    }

    private RowScene refused(Right<I, O> right, String why) {
        I input = right.hazard().input();
        return new RowScene(
                right(input, right.exact()),
                new boolean[0],
                new double[0],
                new Verdict(Verdict.Kind.REFUSED, Deviation.NONE, why),
                pixel -> numbers(input, right.exact(), Optional.empty(), pixel),
                image(input));
    }
}
