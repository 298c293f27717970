package rasterlab.engine.clip.polygon;

import rasterlab.engine.clip.Fraction;

/**
 * A place on the rim of a counter-clockwise window, where the subject's boundary passes it.
 *
 * @param side the side it lies on; a corner belongs to the side that begins there
 * @param along the coordinate along the side's longer extent, without rounding
 * @param falling whether that coordinate falls along the side
 * @param x the nearest double, as is y
 */
record RimPoint(int side, Fraction along, boolean falling, double x, double y)
        implements Comparable<RimPoint> {

    /** The point this share of the way from p to q; it lies on that side of the window. */
    static RimPoint of(
            Ring window, int side, Fraction share, double px, double py, double qx, double qy) {
        double x = share.between(px, qx);
        double y = share.between(py, qy);
        boolean level = isLevel(window, side);
        Fraction along = level ? share.way(px, qx) : share.way(py, qy);
        double end = level ? window.x(side + 1) : window.y(side + 1);
        if (along.compareTo(end) == 0) return corner(window, (side + 1) % window.size());
        double start = level ? window.x(side) : window.y(side);
        if (along.compareTo(start) == 0) return corner(window, side);
        return new RimPoint(side, along, end < start, x, y);
    }

    private static RimPoint corner(Ring window, int side) {
        double x = window.x(side);
        double y = window.y(side);
        boolean level = isLevel(window, side);
        double start = level ? x : y;
        double end = level ? window.x(side + 1) : window.y(side + 1);
        Fraction along = Fraction.ONE.way(start, start);
        return new RimPoint(side, along, end < start, x, y);
    }

    /**
     * Whether x changes most along a side: a difference of doubles is 0 only between equal ones.
     */
    private static boolean isLevel(Ring window, int side) {
        double width = Math.abs(window.x(side + 1) - window.x(side));
        return width >= Math.abs(window.y(side + 1) - window.y(side));
    }

    /** Order counter-clockwise along the rim, from the window's first corner. */
    @Override
    public int compareTo(RimPoint other) {
        if (side != other.side) return Integer.compare(side, other.side);
        int order = along.compareTo(other.along);
        return falling ? -order : order;
    }
}
