package rasterlab.app.row;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.lab.CommandInput;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

/**
 * How a topic's inputs and outputs look as rows.
 *
 * @param <C> contract of the topic's methods
 * @param <I> its input
 * @param <O> its output
 */
abstract class RowKind<C, I, O> {
    private final Topic<C, I, O> topic;
    private final RowAnswers<C, I, O> answers;

    RowKind(Topic<C, I, O> topic) {
        this.topic = topic;
        answers = new RowAnswers<>(topic);
    }

    final Topic<C, I, O> topic() {
        return topic;
    }

    /** Whether the questions of an exercise ask for steps of its methods. */
    boolean asksSteps() {
        return false;
    }

    abstract int pixels(I input);

    abstract List<RowScene.ColorBand> right(I input, O exact);

    abstract List<RowScene.ColorBand> made(I input, O actual);

    /** The error of a pixel in the topic's unit. */
    abstract double error(I input, O exact, O actual, int pixel);

    abstract boolean wrong(I input, O exact, O actual, int pixel);

    abstract RowScene.PixelNumbers numbers(I input, O exact, Optional<O> actual, int pixel);

    /** The input as {@code ./lab run} reads it. */
    String json(I input) {
        return CommandInput.of(topic.format(), input);
    }

    /** The name of an input in the place of a hazard's. */
    @SuppressWarnings("unchecked") // of this topic
    final String given(Object input) {
        return json((I) input);
    }

    /** All of the input, signs of zeros among it. */
    final String whole(String hazard) {
        return GivenInput.name(topic, hazard(hazard).input());
    }

    final String json(String hazard) {
        return json(hazard(hazard).input());
    }

    Optional<RowScene.FilteredImage> image(I input) {
        return Optional.empty();
    }

    /**
     * Takes longer than a frame.
     *
     * @throws IllegalArgumentException if there is no such hazard or method
     */
    final RowScene scene(RowChoice choice) {
        Hazard<I> hazard = hazard(choice.hazard());
        RowAnswers.RowAnswer<O> answer = answers.answer(hazard, choice.method());
        return answer.actual()
                .map(actual -> scene(hazard.input(), actual, answer))
                .orElseGet(() -> without(hazard.input(), answer));
    }

    final int pixels(String hazard) {
        return pixels(hazard(hazard).input());
    }

    private Hazard<I> hazard(String name) {
        return GivenInput.hazard(topic, name);
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

    /** Finds the right answer, so that {@link #scene} is quicker; takes long. */
    final void prepare(String hazard) {
        answers.right(hazard(hazard));
    }

    private RowScene scene(I input, O actual, RowAnswers.RowAnswer<O> answer) {
        O exact = answer.exact();
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
                answer.verdict(),
                pixel -> numbers(input, exact, Optional.of(actual), pixel),
                image(input));
    }

    private RowScene without(I input, RowAnswers.RowAnswer<O> answer) {
        return new RowScene(
                right(input, answer.exact()),
                new boolean[0],
                new double[0],
                answer.verdict(),
                pixel -> numbers(input, answer.exact(), Optional.empty(), pixel),
                image(input));
    }
}
