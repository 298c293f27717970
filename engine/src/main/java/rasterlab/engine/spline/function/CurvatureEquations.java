package rasterlab.engine.spline.function;

import rasterlab.contract.SplineEnds;

/**
 * The equations of the cubic spline's second derivatives M, tridiagonal whatever the ends.
 *
 * <p>Not-a-knot: each end equation has three unknowns; with that of the next knot it gives one
 * equation without the end's, which is found last. Periodic: M at the last knot before the end
 * stands in the first row and has a row of its own at the bottom; the rows above are solved for two
 * right-hand sides, r and what multiplies that M, and the bottom row then gives it.
 */
final class CurvatureEquations {
    private final Knots knots;
    private final SplineEnds.Kind kind;

    /** Knot of the first row: 1 where the end's unknown is found last. */
    private final int first;

    private final double[] lower;
    private final double[] diagonal;
    private final double[] upper;
    private final double[] right;
    private final double[] ofLast;
    private final TridiagonalWalk walk;

    /**
     * @param knots at least two pieces where the ends are periodic, three where they are not-a-knot
     */
    CurvatureEquations(Knots knots, SplineEnds ends) {
        this.knots = knots;
        kind = ends.kind();
        int m = knots.pieces;
        first = kind == SplineEnds.Kind.NOT_A_KNOT ? 1 : 0;
        int rows = kind == SplineEnds.Kind.PERIODIC ? m - 1 : m + 1 - 2 * first;
        lower = new double[rows];
        diagonal = new double[rows];
        upper = new double[rows];
        right = new double[rows];
        ofLast = new double[rows];
        for (int i = 1; i < Math.min(m, rows + first); i++)
            set(i - first, knots.shareBefore(i), 2, knots.shareAfter(i), knots.bend(i - 1, i));
        switch (kind) {
            case SLOPES -> slopes(ends, rows - 1);
            case NATURAL -> natural(rows - 1);
            case NOT_A_KNOT -> notAKnot(rows - 1);
            case PERIODIC -> periodic(rows - 1);
        }
        walk =
                kind == SplineEnds.Kind.PERIODIC
                        ? new TridiagonalWalk(lower, diagonal, upper, right, ofLast)
                        : new TridiagonalWalk(lower, diagonal, upper, right);
    }

    TridiagonalWalk walk() {
        return walk;
    }

    private void set(int row, double before, double middle, double after, double value) {
        lower[row] = before;
        diagonal[row] = middle;
        upper[row] = after;
        right[row] = value;
    }

    private void slopes(SplineEnds ends, int last) {
        int m = knots.pieces;
        set(0, 0, 2, 1, 6 * (knots.secant[0] - ends.left()) / knots.width[0]);
        set(last, 1, 2, 0, 6 * (ends.right() - knots.secant[m - 1]) / knots.width[m - 1]);
    }

    private void natural(int last) {
        set(0, 0, 1, 0, 0);
        set(last, 0, 1, 0, 0);
    }

    /** (1 + λ)·M[1] + (λ − μ)·M[2] = λ·r[1] for the shares μ outside and λ inside of knot 1. */
    private void notAKnot(int last) {
        double inside = knots.shareAfter(1);
        diagonal[0] = 1 + inside;
        upper[0] = inside - knots.shareBefore(1);
        right[0] *= inside;
        inside = knots.shareBefore(knots.pieces - 1);
        diagonal[last] = 1 + inside;
        lower[last] = inside - knots.shareAfter(knots.pieces - 1);
        right[last] *= inside;
    }

    private void periodic(int last) {
        int end = knots.pieces - 1;
        double before = knots.width[end] / (knots.width[end] + knots.width[0]);
        double after = 1 - before;
        set(0, 0, 2, after, knots.bend(end, 0));
        ofLast[0] = before;
        ofLast[last] += upper[last];
    }

    /** M at every knot, once the walk is drained. */
    double[] curvatures() {
        var all = new double[knots.pieces + 1];
        System.arraycopy(right, 0, all, first, right.length);
        if (kind == SplineEnds.Kind.NOT_A_KNOT) {
            int last = knots.pieces;
            all[0] = outer(all[1], all[2], 0, 1);
            all[last] = outer(all[last - 1], all[last - 2], last - 1, last - 2);
        }
        if (kind == SplineEnds.Kind.PERIODIC) closePeriod(all);
        return all;
    }

    /**
     * M at an end knot, from the equation in which it counts most.
     *
     * @param next M at the next knot inward
     * @param third M at the one after it
     * @param outer the piece at the end
     * @param inner the next piece inward
     */
    private double outer(double next, double third, int outer, int inner) {
        double wide = knots.width[outer];
        double narrow = knots.width[inner];
        if (wide < narrow) return next + wide / narrow * (next - third);
        double both = wide + narrow;
        double bend = knots.bend(Math.min(outer, inner), Math.max(outer, inner));
        return ((bend - 2 * next) * both - narrow * third) / wide;
    }

    private void closePeriod(double[] all) {
        int end = knots.pieces - 1;
        double before = knots.shareBefore(end);
        double after = knots.shareAfter(end);
        all[end] =
                (knots.bend(end - 1, end) - before * right[end - 1] - after * right[0])
                        / (2 - before * ofLast[end - 1] - after * ofLast[0]);
        for (int i = 0; i < end; i++) all[i] = right[i] - all[end] * ofLast[i];
        all[end + 1] = all[0];
    }
}
