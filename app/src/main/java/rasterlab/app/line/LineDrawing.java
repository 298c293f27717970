package rasterlab.app.line;

import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/**
 * What one method draws for one segment, pixel by pixel, beside the exact line.
 *
 * <p>Of a segment with more than {@link #LIMIT} pixels only the first ones are drawn and compared.
 *
 * @param difference of all pixels, lit or not yet lit
 * @param deviation how far all pixels are from the exact line
 */
public record LineDrawing(
        String method, LineTrace trace, PixelDifference difference, Deviation deviation) {
    /** The most pixels that the lab draws of a segment. */
    public static final int LIMIT = 4096;

    /**
     * @throws IllegalArgumentException if the topic has no method of that name
     */
    static LineDrawing of(
            Topic<LineRasterizer, Segment, PixelRecording> topic, String method, Segment segment) {
        LineTrace trace = LineTrace.of(topic.method(method).implementation(), segment, LIMIT);
        PixelRecording exact = topic.exact(segment, LIMIT);
        return new LineDrawing(
                method,
                trace,
                PixelDifference.of(exact, trace.pixels()),
                topic.compare(segment, exact, trace.pixels()));
    }

    /** Number of pixels drawn, at most {@link #LIMIT}. */
    public int pixels() {
        return trace.pixels().size();
    }

    /** The pixels that the first {@code steps} steps lit. */
    PixelSet lit(int steps) {
        if (steps == pixels()) return PixelSet.of(trace.pixels());
        var lit = new PixelRecording(Math.max(1, steps));
        for (int step = 1; step <= steps; step++) lit.plot(x(step), y(step));
        return PixelSet.of(lit);
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
