package rasterlab.engine.visibility.painter;

/**
 * One side of a straight line on the picture, the near one where {@code base + x·perColumn +
 * y·perRow} ≥ 0. Of the two sides each pixel is on just one.
 */
record CutLine(double base, double perColumn, double perRow, boolean near) {

    /** The first pixel of [from, to) of a row that is on this side, {@code to} if none is. */
    int from(int row, int from, int to) {
        if (perColumn == 0) return (at(row) >= 0) == near ? from : to;
        return near == perColumn > 0 ? within(border(row), from, to) : from;
    }

    /** The pixel after the last of [from, to) that is on this side, {@code from} if none is. */
    int to(int row, int from, int to) {
        if (perColumn == 0) return (at(row) >= 0) == near ? to : from;
        return near == perColumn > 0 ? to : within(border(row), from, to);
    }

    private double at(int row) {
        return base + row * perRow;
    }

    /** The first column beyond the line, which itself is on the near side. */
    private double border(int row) {
        double crossing = -at(row) / perColumn;
        return perColumn > 0 ? Math.ceil(crossing) : Math.floor(crossing) + 1;
    }

    private static int within(double column, int from, int to) {
        return (int) Math.max(from, Math.min(to, column));
    }
}
