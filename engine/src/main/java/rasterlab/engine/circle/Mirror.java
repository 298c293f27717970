package rasterlab.engine.circle;

import rasterlab.contract.Pixels;

/** Sends the mirror images of a pixel counted from a centre, each once. */
record Mirror(int centerX, int centerY, Pixels out) {
    /**
     * @throws IllegalArgumentException if the extent is below 0 or leaves the range of int
     */
    static Mirror about(int centerX, int centerY, int radiusX, int radiusY, Pixels out) {
        requireRoom(centerX, centerY, radiusX, radiusY);
        return new Mirror(centerX, centerY, out);
    }

    /**
     * Passes if every coordinate of such a curve is an int.
     *
     * @throws IllegalArgumentException if a radius is below 0 or the curve leaves the range of int
     */
    static void requireRoom(int centerX, int centerY, int radiusX, int radiusY) {
        check("x", centerX, radiusX);
        check("y", centerY, radiusY);
    }

    private static void check(String axis, int center, int radius) {
        if (radius < 0)
            throw new IllegalArgumentException(
                    "radius along " + axis + " must be 0 or more pixels, got " + radius);
        if ((long) center - radius < Integer.MIN_VALUE
                || (long) center + radius > Integer.MAX_VALUE)
            throw new IllegalArgumentException(
                    "centre "
                            + center
                            + " ± radius "
                            + radius
                            + " along "
                            + axis
                            + " must lie in -2147483648..2147483647");
    }

    /** Plots the pixel and its images across both axes: four, two on an axis, one in the centre. */
    void four(int u, int v) {
        out.plot(centerX + u, centerY + v);
        if (u != 0) out.plot(centerX - u, centerY + v);
        if (v == 0) return;
        out.plot(centerX + u, centerY - v);
        if (u != 0) out.plot(centerX - u, centerY - v);
    }

    /** Plots the same, and all of it across the diagonals: eight, four on an axis or a diagonal. */
    void eight(int u, int v) {
        four(u, v);
        if (u != v) four(v, u);
    }
}
