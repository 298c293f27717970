package rasterlab.app.line;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelSet;

/**
 * The wrong pixels that can be told at a step: extra ones as soon as they are lit, missing ones
 * when the method has ended.
 */
public final class LineMarks {
    private final PixelDifference difference;
    private final PixelSet lit;
    private final boolean finished;

    private LineMarks(PixelDifference difference, PixelSet lit, boolean finished) {
        this.difference = difference;
        this.lit = lit;
        this.finished = finished;
    }

    public static LineMarks of(LineLabState state) {
        return new LineMarks(
                state.drawing().difference(), state.drawing().lit(state.step()), state.finished());
    }

    public int missingCount() {
        return finished ? difference.missing().size() : 0;
    }

    public int extraCount() {
        int[] count = {0};
        extra((x, y) -> count[0]++);
        return count[0];
    }

    public void missing(Pixels out) {
        if (finished) each(difference.missing(), out);
    }

    public void extra(Pixels out) {
        each(difference.extra().filter(lit::contains), out);
    }

    private static void each(PixelSet set, Pixels out) {
        for (int i = 0; i < set.size(); i++) out.plot(set.x(i), set.y(i));
    }
}
