package rasterlab.engine.spline.exact;

import java.math.BigInteger;
import rasterlab.contract.Curve;

/**
 * Points of a curve, rounded once, each kind by its own definition: Bernstein's polynomials,
 * Hermite's conditions, the pyramid of Barry and Goldman, the recursion of Cox and de Boor.
 */
public final class ExactCurve {
    private static final BinaryFraction ONE = BinaryFraction.of(1);

    private final Curve curve;

    public ExactCurve(Curve curve) {
        this.curve = curve;
    }

    public double x(double t) {
        return value(curve.x(), BinaryFraction.of(t));
    }

    public double y(double t) {
        return value(curve.y(), BinaryFraction.of(t));
    }

    private double value(double[] points, BinaryFraction t) {
        BinaryFraction place = t.times(BinaryFraction.of(curve.spans()));
        int span = Math.min(place.floor(), curve.spans() - 1);
        BinaryFraction u = place.minus(BinaryFraction.of(span));
        return switch (curve.kind()) {
            case BEZIER -> bernstein(points, u).toDouble();
            case HERMITE -> hermite(points, u).toDouble();
            case CATMULL_ROM -> pyramid(points, span, u).toDouble();
            case B_SPLINE -> deBoor(points, span, u);
        };
    }

    /** Σ C(n, i)·uⁱ·(1 − u)ⁿ⁻ⁱ·pᵢ; 1 − u is multiplied in term by term. */
    private static BinaryFraction bernstein(double[] points, BinaryFraction u) {
        int n = points.length - 1;
        BinaryFraction rest = ONE.minus(u);
        BinaryFraction sum = BinaryFraction.ZERO;
        BinaryFraction power = ONE;
        BigInteger choices = BigInteger.ONE;
        for (int i = 0; i <= n; i++) {
            sum = sum.times(rest).plus(BinaryFraction.of(points[i]).times(choices).times(power));
            power = power.times(u);
            choices = choices.multiply(BigInteger.valueOf(n - i)).divide(BigInteger.valueOf(i + 1));
        }
        return sum;
    }

    /** Start + slope·u and what is left to the end and its slope: c·u² + d·u²·(u − 1). */
    private static BinaryFraction hermite(double[] points, BinaryFraction u) {
        BinaryFraction start = BinaryFraction.of(points[0]);
        BinaryFraction slope = BinaryFraction.of(points[2]);
        BinaryFraction c = BinaryFraction.of(points[1]).minus(start).minus(slope);
        BinaryFraction d = BinaryFraction.of(points[3]).minus(slope).minus(c.plus(c));
        BinaryFraction square = u.times(u);
        return start.plus(slope.times(u))
                .plus(c.times(square))
                .plus(d.times(square).times(u.minus(ONE)));
    }

    /** Straight lines through neighbours, blended, at knots −1, 0, 1, 2; u runs from 0 to 1. */
    private static BinaryFraction pyramid(double[] points, int span, BinaryFraction u) {
        var row = new BinaryFraction[4];
        for (int i = 0; i < 4; i++) row[i] = BinaryFraction.of(points[span + i]);
        lines(row, 3, ONE, u, -1);
        lines(row, 2, BinaryFraction.of(0.5), u, -1);
        lines(row, 1, ONE, u, 0);
        return row[0];
    }

    private static void lines(
            BinaryFraction[] row, int count, BinaryFraction perWidth, BinaryFraction u, int first) {
        for (int i = 0; i < count; i++) {
            BinaryFraction share = u.minus(BinaryFraction.of(first + i)).times(perWidth);
            row[i] = row[i].plus(share.times(row[i + 1].minus(row[i])));
        }
    }

    /** Cubic basis functions at whole knots; the one of point i lives on knots i to i + 4. */
    private static double deBoor(double[] points, int span, BinaryFraction u) {
        BinaryFraction place = u.plus(BinaryFraction.of(3));
        BinaryFraction sum = BinaryFraction.ZERO;
        for (int i = 0; i < 4; i++)
            sum = sum.plus(BinaryFraction.of(points[span + i]).times(basis(i, 3, place)));
        return sum.dividedBy(3 * 2);
    }

    /** The basis function, times each degree that the recursion divides by. */
    private static BinaryFraction basis(int knot, int degree, BinaryFraction place) {
        if (degree == 0) return knot == 3 ? ONE : BinaryFraction.ZERO;
        BinaryFraction in = place.minus(BinaryFraction.of(knot));
        BinaryFraction out = BinaryFraction.of(knot + degree + 1).minus(place);
        return in.times(basis(knot, degree - 1, place))
                .plus(out.times(basis(knot + 1, degree - 1, place)));
    }
}
