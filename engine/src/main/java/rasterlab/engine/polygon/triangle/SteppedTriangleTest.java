package rasterlab.engine.polygon.triangle;

import rasterlab.contract.PointInTriangle;

/**
 * A method that asks side after side and stops at the first that settles the answer: judging and
 * stepping drain the same walk.
 */
public interface SteppedTriangleTest extends PointInTriangle {
    /**
     * A walk round the triangle's sides for one point.
     *
     * @throws IllegalArgumentException as {@code contains} does
     */
    SideWalk walk(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y);

    /** The formula of {@link SideWalk#value}, and which values mean inside. */
    String valueFormula();

    /**
     * The two corners, 0 for a, 1 for b, 2 for c, of the side that a walk asks as number {@code
     * side}; the same corner twice where the method asks corner after corner.
     */
    default int[] corners(int side) {
        return new int[] {side, (side + 1) % 3};
    }
}
