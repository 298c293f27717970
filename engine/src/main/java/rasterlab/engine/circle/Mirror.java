package rasterlab.engine.circle;

import rasterlab.contract.Pixels;

/** Sends the mirror images of a pixel counted from a centre, each once. */
record Mirror(int centreX, int centreY, Pixels out) {
    /**
     * @throws IllegalArgumentException if the extent is below 0 or leaves the range of int
     */
    static Mirror about(int centreX, int centreY, int radiusX, int radiusY, Pixels out) {
        requireRoom(centreX, centreY, radiusX, radiusY);
        return new Mirror(centreX, centreY, out);
    }

    /**
     * Passes if every coordinate of such a curve is an int.
     *
     * @throws IllegalArgumentException if a radius is below 0 or the curve leaves the range of int
     */
    static void requireRoom(int centreX, int centreY, int radiusX, int radiusY) {
        check("x", centreX, radiusX);
        check("y", centreY, radiusY);
    }

    private static void check(String axis, int centre, int radius) {
        if (radius < 0)
            throw new IllegalArgumentException(
                    "radius along " + axis + " must be 0 or more pixels, got " + radius);
        if ((long) centre - radius < Integer.MIN_VALUE
                || (long) centre + radius > Integer.MAX_VALUE)
            throw new IllegalArgumentException(
                    "centre "
                            + centre
                            + " ± radius "
                            + radius
                            + " along "
                            + axis
                            + " must lie in -2147483648..2147483647");
    }

    /** Plots the pixel and its images across both axes: four, two on an axis, one in the centre. */
    void four(int u, int v) {
        out.plot(centreX + u, centreY + v);
        if (u != 0) out.plot(centreX - u, centreY + v);
        if (v == 0) return;
        out.plot(centreX + u, centreY - v);
        if (u != 0) out.plot(centreX - u, centreY - v);
    }

    /** Plots the same, and all of it across the diagonals: eight, four on an axis or a diagonal. */
    void eight(int u, int v) {
        four(u, v);
        if (u != v) four(v, u);
    }
}
