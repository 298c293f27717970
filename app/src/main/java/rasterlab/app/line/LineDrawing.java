package rasterlab.app.line;

import java.util.List;
import java.util.Optional;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.CoverageLine;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/**
 * The drawing of one method for one segment, pixel by pixel, beside the exact line.
 *
 * <p>Of a segment with more than {@link #LIMIT} pixels only the first ones are drawn and compared.
 *
 * @param difference of all pixels, lit or not yet lit; of covered ones by their coverage
 * @param marks the wrong ones, step by step
 * @param deviation how far all pixels are from the exact line, of covered ones those covered by at
 *     least a half
 * @param coverage of the pixels, where the method covers them in part
 */
public record LineDrawing(
        String method,
        LineTrace trace,
        PixelDifference difference,
        LineMarks marks,
        Deviation deviation,
        Optional<Covered> coverage) {
    /**
     * @param worst the largest difference of a pixel's coverage from the exact one, in levels
     */
    public record Covered(PixelCoverage drawn, int worst) {}

    /** The most pixels that the lab draws of a segment. */
    public static final int LIMIT = 4096;

    /**
     * @param exact the first {@link #LIMIT} pixels of the exact line
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static LineDrawing of(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            String method,
            Segment segment,
            PixelRecording exact) {
        return of(topic, method, topic.method(method).implementation(), segment, exact);
    }

    /**
     * @param rasterizer maybe one that the topic does not know
     * @param exact the first {@link #LIMIT} pixels of the exact line
     */
    static LineDrawing of(
            Topic<LineRasterizer, Segment, PixelRecording> topic,
            String method,
            LineRasterizer rasterizer,
            Segment segment,
            PixelRecording exact) {
        LineTrace trace = LineTrace.of(rasterizer, segment, LIMIT);
        Deviation deviation = topic.compare(segment, exact, trace.pixels());
        if (rasterizer instanceof CoverageLine shaded && trace.pixels().size() > 0)
            return covered(method, shaded, segment, exact, trace, deviation);
        PixelDifference difference = PixelDifference.of(exact, trace.pixels());
        LineMarks marks = LineMarks.of(difference, trace.pixels());
        return new LineDrawing(method, trace, difference, marks, deviation, Optional.empty());
    }

    private static LineDrawing covered(
            String name,
            CoverageLine method,
            Segment segment,
            PixelRecording nearest,
            LineTrace trace,
            Deviation deviation) {
        PixelCoverage exact = PixelCoverage.exact(segment, nearest);
        PixelCoverage drawn = PixelCoverage.of(method, segment, LIMIT);
        PixelDifference difference = drawn.differenceFrom(exact);
        LineMarks marks =
                LineMarks.of(difference, drawn.pixels(), drawn.steps(), trace.pixels().size());
        var covered = new Covered(drawn, drawn.worst(exact));
        return new LineDrawing(name, trace, difference, marks, deviation, Optional.of(covered));
    }

    /**
     * Missing is what only the other method lights, extra what only this one does; where one covers
     * pixels in part, what is covered less or more by it, by more than one level. Empty where one
     * refused the segment.
     */
    Optional<PixelDifference> differenceFrom(LineDrawing other) {
        if (refused() || other.refused()) return Optional.empty();
        return Optional.of(
                coverage.isEmpty() && other.coverage.isEmpty()
                        ? PixelDifference.of(other.trace.pixels(), trace.pixels())
                        : covered().differenceFrom(other.covered()));
    }

    private boolean refused() {
        return trace.ending() == LineTrace.TraceEnding.REFUSED;
    }

    /** The coverage of the pixels; lit ones are covered wholly. */
    private PixelCoverage covered() {
        return coverage.map(Covered::drawn).orElseGet(() -> PixelCoverage.whole(trace.pixels()));
    }

    /** Number of pixels drawn, at most {@link #LIMIT}. */
    public int pixels() {
        return trace.pixels().size();
    }

    /** Column of the pixel that step {@code step} lit, counted from 1. */
    public int x(int step) {
        return trace.pixels().x(step - 1);
    }

    /** Row of the pixel that step {@code step} lit, counted from 1. */
    public int y(int step) {
        return trace.pixels().y(step - 1);
    }

    /** The pixels that step {@code step} lit, counted from 1; one wholly where none is covered. */
    List<PixelCoverage.Shade> shades(int step) {
        return coverage.map(covered -> covered.drawn().at(step))
                .orElseGet(
                        () ->
                                List.of(
                                        new PixelCoverage.Shade(
                                                step, x(step), y(step), CoverageLine.FULL)));
    }
}
