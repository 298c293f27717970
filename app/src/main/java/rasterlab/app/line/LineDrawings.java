package rasterlab.app.line;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Topic;

/**
 * The drawings for one choice: both methods beside the one exact line.
 *
 * @param exact the first {@link LineDrawing#LIMIT} pixels of the exact line
 * @param drawing by the chosen method
 * @param tried what a program of the user's did with the segment, if that is shown
 * @param other by the second method, if one is compared, or what the program drew
 * @param apart pixels of two methods: extra is what only the chosen one lights, or covers more,
 *     missing what only the second one does; empty where one refused or none is compared
 */
public record LineDrawings(
        LineChoice choice,
        PixelRecording exact,
        LineDrawing drawing,
        Optional<TrialSegment> tried,
        Optional<LineDrawing> other,
        Optional<PixelDifference> apart) {

    static LineDrawings of(
            Topic<LineRasterizer, Segment, PixelRecording> topic, LineChoice choice) {
        PixelRecording exact = topic.exact(choice.segment(), LineDrawing.LIMIT);
        return of(topic, choice, Optional.empty(), exact, () -> false);
    }

    /**
     * The drawings of another choice; the exact line of the same segment is not made again.
     *
     * @param tried left out where it does not fit the choice
     * @param cancelled asked before each of the three parts
     * @throws CancellationException once {@code cancelled} says true
     */
    LineDrawings next(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            LineChoice next,
            Optional<TrialSegment> tried,
            BooleanSupplier cancelled) {
        requireUse(cancelled);
        return of(
                topic,
                next,
                tried.filter(one -> one.fits(next)),
                next.segment().equals(choice.segment())
                        ? exact
                        : topic.exact(next.segment(), LineDrawing.LIMIT),
                cancelled);
    }

    private static LineDrawings of(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            LineChoice choice,
            Optional<TrialSegment> tried,
            PixelRecording exact,
            BooleanSupplier cancelled) {
        requireUse(cancelled);
        Segment segment = choice.segment();
        LineDrawing drawing = LineDrawing.of(topic, choice.method(), segment, exact);
        requireUse(cancelled);
        Optional<LineDrawing> other =
                choice.comparison().isEmpty()
                        ? tried.flatMap(program -> drawn(program, topic, exact))
                        : Optional.of(LineDrawing.of(topic, choice.comparison(), segment, exact));
        return new LineDrawings(
                choice,
                exact,
                drawing,
                tried,
                other,
                other.flatMap(second -> apart(drawing, second, tried)));
    }

    private static Optional<LineDrawing> drawn(
            TrialSegment program,
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            PixelRecording exact) {
        PixelRecording known = program.comparable(exact);
        return program.method()
                .map(by -> LineDrawing.of(topic, TrialSegment.NAME, by, program.segment(), known));
    }

    private static Optional<PixelDifference> apart(
            LineDrawing drawing, LineDrawing other, Optional<TrialSegment> tried) {
        Optional<TrialSegment> cut = tried.filter(program -> program.first().isPresent());
        if (cut.isEmpty()) return drawing.differenceFrom(other);
        PixelRecording known = cut.get().comparable(drawing.trace().pixels());
        return Optional.of(PixelDifference.of(other.trace().pixels(), known));
    }

    private static void requireUse(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer choice was made");
    }
}
