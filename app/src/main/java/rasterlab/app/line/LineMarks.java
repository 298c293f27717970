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
    private final PixelSet missing;

    /** The steps that lit an extra pixel for the first time, counted from 1, ascending. */
    private final int[] extraSteps;

    private LineMarks(PixelRecording pixels, PixelSet missing, int[] extraSteps) {
        this.pixels = pixels;
        this.missing = missing;
        this.extraSteps = extraSteps;
    }

    /**
     * @param pixels what the method lit, in order
     */
    static LineMarks of(PixelDifference difference, PixelRecording pixels) {
        Set<Point> unseen = new HashSet<>();
        PixelSet extra = difference.extra();
        for (int i = 0; i < extra.size(); i++) unseen.add(new Point(extra.x(i), extra.y(i)));
        int[] steps =
                IntStream.rangeClosed(1, pixels.size())
                        .filter(
                                step ->
                                        unseen.remove(
                                                new Point(pixels.x(step - 1), pixels.y(step - 1))))
                        .toArray();
        return new LineMarks(pixels, difference.missing(), steps);
    }

    public int missingCount(int step) {
        return finished(step) ? missing.size() : 0;
    }

    public int extraCount(int step) {
        return (int) IntStream.of(extraSteps).takeWhile(lit -> lit <= step).count();
    }

    public void missing(int step, Pixels out) {
        if (finished(step))
            for (int i = 0; i < missing.size(); i++) out.plot(missing.x(i), missing.y(i));
    }

    public void extra(int step, Pixels out) {
        for (int lit : extraSteps) if (lit <= step) out.plot(pixels.x(lit - 1), pixels.y(lit - 1));
    }

    private boolean finished(int step) {
        return step == pixels.size();
    }
}
