package rasterlab.engine.spline;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.Curve;

/**
 * Points of a curve to {@value #DIGITS} digits, each kind by its own definition: Bernstein's
 * polynomials, Hermite's conditions, the pyramid of Barry and Goldman, the recursion of Cox and de
 * Boor.
 */
final class ExactCurve {
    private static final int DIGITS = 60;
    private static final MathContext PRECISE = new MathContext(DIGITS);
    private static final BigDecimal ONE = BigDecimal.ONE;

    private final Curve curve;

    ExactCurve(Curve curve) {
        this.curve = curve;
    }

    double x(double t) {
        return value(curve.x(), new BigDecimal(t)).doubleValue();
    }

    double y(double t) {
        return value(curve.y(), new BigDecimal(t)).doubleValue();
    }

    private BigDecimal value(double[] points, BigDecimal t) {
        BigDecimal place = t.multiply(BigDecimal.valueOf(curve.spans()));
        int span = Math.min(place.intValue(), curve.spans() - 1);
        BigDecimal u = place.subtract(BigDecimal.valueOf(span));
        return switch (curve.kind()) {
            case BEZIER -> bernstein(points, u);
            case HERMITE -> hermite(points, u);
            case CATMULL_ROM -> pyramid(points, span, u);
            case B_SPLINE -> deBoor(points, span, u);
        };
    }

    private static BigDecimal bernstein(double[] points, BigDecimal u) {
        int n = points.length - 1;
        BigDecimal rest = ONE.subtract(u);
        BigDecimal sum = BigDecimal.ZERO;
        BigDecimal choices = ONE;
        for (int i = 0; i <= n; i++) {
            BigDecimal weight = u.pow(i, PRECISE).multiply(rest.pow(n - i, PRECISE), PRECISE);
            sum = sum.add(new BigDecimal(points[i]).multiply(weight).multiply(choices), PRECISE);
            choices =
                    choices.multiply(BigDecimal.valueOf(n - i))
                            .divide(BigDecimal.valueOf(i + 1), PRECISE);
        }
        return sum;
    }

    /** Start + slope·u and what is left to the end and its slope: c·u² + d·u²·(u − 1). */
    private static BigDecimal hermite(double[] points, BigDecimal u) {
        BigDecimal start = new BigDecimal(points[0]);
        BigDecimal slope = new BigDecimal(points[2]);
        BigDecimal c = new BigDecimal(points[1]).subtract(start).subtract(slope);
        BigDecimal d = new BigDecimal(points[3]).subtract(slope).subtract(c.add(c));
        BigDecimal square = u.multiply(u);
        return start.add(slope.multiply(u))
                .add(c.multiply(square))
                .add(d.multiply(square).multiply(u.subtract(ONE)));
    }

    /** Straight lines through neighbours, blended, at knots −1, 0, 1, 2; u runs from 0 to 1. */
    private static BigDecimal pyramid(double[] points, int span, BigDecimal u) {
        var row = new BigDecimal[4];
        for (int i = 0; i < 4; i++) row[i] = new BigDecimal(points[span + i]);
        lines(row, 3, 1, u, -1);
        lines(row, 2, 2, u, -1);
        lines(row, 1, 1, u, 0);
        return row[0];
    }

    private static void lines(BigDecimal[] row, int count, int width, BigDecimal u, int first) {
        for (int i = 0; i < count; i++) {
            BigDecimal share =
                    u.subtract(BigDecimal.valueOf(first + i))
                            .divide(BigDecimal.valueOf(width), PRECISE);
            row[i] = row[i].add(share.multiply(row[i + 1].subtract(row[i])));
        }
    }

    /** Cubic basis functions at whole knots; the one of point i lives on knots i to i + 4. */
    private static BigDecimal deBoor(double[] points, int span, BigDecimal u) {
        BigDecimal place = u.add(BigDecimal.valueOf(3));
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < 4; i++)
            sum = sum.add(new BigDecimal(points[span + i]).multiply(basis(i, 3, place)));
        return sum;
    }

    private static BigDecimal basis(int knot, int degree, BigDecimal place) {
        BigDecimal in = place.subtract(BigDecimal.valueOf(knot));
        if (degree == 0) return knot == 3 ? ONE : BigDecimal.ZERO;
        BigDecimal out = BigDecimal.valueOf(knot + degree + 1).subtract(place);
        return in.multiply(basis(knot, degree - 1, place))
                .add(out.multiply(basis(knot + 1, degree - 1, place)))
                .divide(BigDecimal.valueOf(degree), PRECISE);
    }
}
