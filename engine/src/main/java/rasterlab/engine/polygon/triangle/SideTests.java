package rasterlab.engine.polygon.triangle;

import rasterlab.contract.PointInTriangle;
import rasterlab.engine.geometry.Finite;

/** A method that asks side after side and stops at the first that settles the answer. */
interface SideTests extends PointInTriangle {
    /**
     * How many sides were asked: as it is where the point is inside, negative where outside.
     *
     * @throws IllegalArgumentException as {@code contains} does
     */
    int asked(double ax, double ay, double bx, double by, double cx, double cy, double x, double y);

    @Override
    default boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return asked(ax, ay, bx, by, cx, cy, x, y) > 0;
    }

    /**
     * Passes if all are finite: then their sum times 0 is 0, unless it overflows.
     *
     * @throws IllegalArgumentException naming the value that is not
     */
    static void requireFinite(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        if ((ax + ay + bx + by + cx + cy + x + y) * 0 != 0)
            Finite.require("coordinate", ax, ay, bx, by, cx, cy, x, y);
    }

    /** What one question costs. */
    int multiplicationsPerSide();

    /** What one question costs, subtractions included. */
    int additionsPerSide();
}
