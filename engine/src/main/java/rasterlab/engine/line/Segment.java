package rasterlab.engine.line;

/**
 * A straight segment between two pixel centres, drawn from (x0, y0) to (x1, y1); any int is
 * allowed.
 */
public record Segment(int x0, int y0, int x1, int y1) {
    /** n = max(|x1 − x0|, |y1 − y0|), from 0 to 2³² − 1; the segment has n + 1 pixels. */
    public long steps() {
        return Math.max(Math.abs((long) x1 - x0), Math.abs((long) y1 - y0));
    }

    /** The same segment drawn from its far end. */
    public Segment reversed() {
        return new Segment(x1, y1, x0, y0);
    }

    @Override
    public String toString() {
        return "(" + x0 + ", " + y0 + ")→(" + x1 + ", " + y1 + ")";
    }
}
