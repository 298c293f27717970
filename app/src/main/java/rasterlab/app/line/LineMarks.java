package rasterlab.app.line;

import java.awt.Point;
import java.util.HashSet;
import java.util.Set;
import java.util.stream.IntStream;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelSet;

/**
 * The wrong pixels of one drawing that can be told after a number of steps: extra ones as soon as
 * they are lit, missing ones when the method has ended.
 */
public final class LineMarks {
    private final PixelRecording pixels;

    /** The step that lit each pixel, counted from 1. */
    private final int[] steps;

    private final int last;
    private final PixelSet missing;

    /** The extra pixels that were not lit before, ascending. */
    private final int[] extra;

    private LineMarks(PixelRecording pixels, int[] steps, int last, PixelSet missing, int[] extra) {
        this.pixels = pixels;
        this.steps = steps;
        this.last = last;
        this.missing = missing;
        this.extra = extra;
    }

    /**
     * @param pixels what the method lit, in order
     */
    static LineMarks of(PixelDifference difference, PixelRecording pixels) {
        int last = pixels.size();
        return of(difference, pixels, IntStream.rangeClosed(1, last).toArray(), last);
    }

    /**
     * @param steps the step that lit each pixel, counted from 1, ascending
     * @param last step
     */
    static LineMarks of(PixelDifference difference, PixelRecording pixels, int[] steps, int last) {
        Set<Point> unseen = new HashSet<>();
        PixelSet wrong = difference.extra();
        for (int i = 0; i < wrong.size(); i++) unseen.add(new Point(wrong.x(i), wrong.y(i)));
        int[] extra =
                IntStream.range(0, pixels.size())
                        .filter(i -> unseen.remove(new Point(pixels.x(i), pixels.y(i))))
                        .toArray();
        return new LineMarks(pixels, steps, last, difference.missing(), extra);
    }

    public int missingCount(int step) {
        return finished(step) ? missing.size() : 0;
    }

    public int extraCount(int step) {
        return (int) IntStream.of(extra).takeWhile(lit -> steps[lit] <= step).count();
    }

    public void missing(int step, Pixels out) {
        if (finished(step))
            for (int i = 0; i < missing.size(); i++) out.plot(missing.x(i), missing.y(i));
    }

    public void extra(int step, Pixels out) {
        for (int lit : extra) if (steps[lit] <= step) out.plot(pixels.x(lit), pixels.y(lit));
    }

    private boolean finished(int step) {
        return step == last;
    }
}
