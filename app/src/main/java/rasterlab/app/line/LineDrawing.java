package rasterlab.app.line;

import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/**
 * What one method draws for one segment, pixel by pixel, beside the exact line.
 *
 * <p>Of a segment with more than {@link #LIMIT} pixels only the first ones are drawn and compared.
 *
 * @param difference of all pixels, lit or not yet lit
 * @param marks the wrong ones, step by step
 * @param deviation how far all pixels are from the exact line
 */
public record LineDrawing(
        String method,
        LineTrace trace,
        PixelDifference difference,
        LineMarks marks,
        Deviation deviation) {
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
        LineTrace trace = LineTrace.of(topic.method(method).implementation(), segment, LIMIT);
        PixelDifference difference = PixelDifference.of(exact, trace.pixels());
        return new LineDrawing(
                method,
                trace,
                difference,
                LineMarks.of(difference, trace.pixels()),
                topic.compare(segment, exact, trace.pixels()));
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
}
