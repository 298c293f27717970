package rasterlab.engine.spline;

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

    /** The piece that {@code place} lies in; the first or the last where it lies outside. */
    public int piece(double place) {
        int piece = 0;
        while (piece < x.length - 2 && place >= x[piece + 1]) piece++;
        return piece;
    }

    @Override
    public String toString() {
        return x.length + " knots, " + ends.kind() + ", " + at.length + " places";
    }
}
