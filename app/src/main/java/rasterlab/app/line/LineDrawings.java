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
 * What was drawn for one choice, both methods beside the one exact line.
 *
 * @param exact the first {@link LineDrawing#LIMIT} pixels of the exact line
 * @param drawing by the chosen method
 * @param other by the second method, if one is compared
 * @param apart pixels of two methods: extra is what only the chosen one lights, or covers more,
 *     missing what only the second one does; empty where one refused or none is compared
 */
public record LineDrawings(
        LineChoice choice,
        PixelRecording exact,
        LineDrawing drawing,
        Optional<LineDrawing> other,
        Optional<PixelDifference> apart) {

    static LineDrawings of(
            Topic<LineRasterizer, Segment, PixelRecording> topic, LineChoice choice) {
        PixelRecording exact = topic.exact(choice.segment(), LineDrawing.LIMIT);
        return of(topic, choice, exact, () -> false);
    }

    /**
     * What another choice draws; the exact line of the same segment is not made again.
     *
     * @param cancelled asked before each of the three parts
     * @throws CancellationException once {@code cancelled} says true
     */
    LineDrawings next(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            LineChoice next,
            BooleanSupplier cancelled) {
        requireUse(cancelled);
        return of(
                topic,
                next,
                next.segment().equals(choice.segment())
                        ? exact
                        : topic.exact(next.segment(), LineDrawing.LIMIT),
                cancelled);
    }

    private static LineDrawings of(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            LineChoice choice,
            PixelRecording exact,
            BooleanSupplier cancelled) {
        requireUse(cancelled);
        Segment segment = choice.segment();
        LineDrawing drawing = LineDrawing.of(topic, choice.method(), segment, exact);
        if (choice.comparison().isEmpty())
            return new LineDrawings(choice, exact, drawing, Optional.empty(), Optional.empty());
        requireUse(cancelled);
        LineDrawing other = LineDrawing.of(topic, choice.comparison(), segment, exact);
        return new LineDrawings(
                choice, exact, drawing, Optional.of(other), drawing.differenceFrom(other));
    }

    private static void requireUse(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer choice was made");
    }
}
