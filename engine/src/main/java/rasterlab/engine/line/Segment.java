package rasterlab.engine.line;

import rasterlab.engine.raster.PixelWindow;

/**
 * A straight segment between two pixel centres, drawn from (x0, y0) to (x1, y1); any int is
 * allowed.
 *
 * @param window what is shown of it; {@link PixelWindow#EVERYTHING} where nothing is cut off
 */
public record Segment(int x0, int y0, int x1, int y1, PixelWindow window) {
    /** The whole segment. */
    public Segment(int x0, int y0, int x1, int y1) {
        this(x0, y0, x1, y1, PixelWindow.EVERYTHING);
    }

    /** This segment, of which only the pixels in the window are shown. */
    public Segment in(PixelWindow window) {
        return new Segment(x0, y0, x1, y1, window);
    }

    /** n = max(|x1 − x0|, |y1 − y0|), from 0 to 2³² − 1; the whole segment has n + 1 pixels. */
    public long steps() {
        return Math.max(Math.abs((long) x1 - x0), Math.abs((long) y1 - y0));
    }

    /** This segment drawn from its far end. */
    public Segment reversed() {
        return new Segment(x1, y1, x0, y0, window);
    }

    /** Whether nothing is cut off. */
    public boolean isWhole() {
        return window.equals(PixelWindow.EVERYTHING);
    }

    @Override
    public String toString() {
        String ends = "(" + x0 + ", " + y0 + ")→(" + x1 + ", " + y1 + ")";
        return isWhole() ? ends : ends + " in " + window;
    }
}
