package rasterlab.engine.spline.function;

import java.math.BigDecimal;
import java.util.Arrays;
import rasterlab.contract.SplineEnds;

/**
 * One input of the topic.
 *
 * @param at where the function's values are wanted
 * @param shape whether values outside those of the two neighbouring knots count as an error of a
 *     method that promises the shape
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

    /** Whether {@code place} lies outside the knots of a function whose period goes on there. */
    boolean folds(double place) {
        return ends.kind() == SplineEnds.Kind.PERIODIC && (place < x[0] || place > x[x.length - 1]);
    }

    /**
     * Where {@code place} comes to lie in the period [x[0], x[last]) when whole periods are taken
     * away or added, exactly: the last knot becomes the first. For the references alone; {@link
     * PiecewiseCubic} folds by itself, so that a fault in one cannot hide in the other.
     *
     * @param place finite
     */
    BigDecimal folded(double place) {
        var first = new BigDecimal(x[0]);
        var last = new BigDecimal(x[x.length - 1]);
        BigDecimal rest = new BigDecimal(place).subtract(first).remainder(last.subtract(first));
        return (rest.signum() < 0 ? last : first).add(rest);
    }

    @Override
    public String toString() {
        return x.length + " knots, " + ends.kind() + ", " + at.length + " places";
    }
}
