package rasterlab.engine.spline;

import java.util.Arrays;
import rasterlab.contract.SplineEnds;

/**
 * One input of the topic.
 *
 * @param at where the function's values are wanted
 * @param shape whether values outside those of the two neighbouring knots count as an error
 */
public record SplineProblem(double[] x, double[] y, SplineEnds ends, double[] at, boolean shape) {
    public SplineProblem {
        x = x.clone();
        y = y.clone();
        at = at.clone();
    }

    /** How many coefficients a method has to find: four for each piece. */
    int coefficients() {
        return 4 * (x.length - 1);
    }

    /**
     * The piece that {@code place} lies in; the first or the last where it lies outside. The knots
     * must increase.
     */
    public int piece(double place) {
        int found = Arrays.binarySearch(x, place + 0.0);
        int below = found >= 0 ? found : -found - 2;
        return Math.max(0, Math.min(below, x.length - 2));
    }

    @Override
    public String toString() {
        return x.length + " knots, " + ends.kind() + ", " + at.length + " places";
    }
}
