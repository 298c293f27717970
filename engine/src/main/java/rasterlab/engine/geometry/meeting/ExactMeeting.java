package rasterlab.engine.geometry.meeting;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Line;

/**
 * The reference: μ in decimal numbers of any length, divided to 40 digits. It answers with the μ
 * nearest to the right one; NaN where there is none, or it is beyond doubles. The common point and
 * the part of the line that it lies in are found from the undivided numbers.
 */
final class ExactMeeting implements LinePlane {
    private static final MathContext DIGITS = new MathContext(40);

    @Override
    public double meets(double[] normal, double c, double[] from, double[] through) {
        return mu(normal, new BigDecimal(c), from, through);
    }

    @Override
    public double meetsThrough(double[] normal, double[] point, double[] from, double[] through) {
        return mu(normal, dot(normal, point), from, through);
    }

    private static double mu(double[] normal, BigDecimal c, double[] from, double[] through) {
        return new Ratio(normal, c, from, through).mu();
    }

    /** The right answer for each line of an input. */
    static Meetings all(PlaneAndLines input) {
        var mu = new double[input.size()];
        var parts = new Line.PositionOnLine[mu.length];
        var points = new double[mu.length][];
        for (int i = 0; i < mu.length; i++) {
            double[] n = input.normal();
            BigDecimal c =
                    input.point().length == 0 ? new BigDecimal(input.c()) : dot(n, input.point());
            var ratio = new Ratio(n, c, input.from()[i], input.through()[i]);
            mu[i] = ratio.mu();
            if (Double.isNaN(mu[i])) continue;
            parts[i] = ratio.part();
            points[i] = ratio.point(input.from()[i], input.through()[i]);
        }
        return new Meetings(mu, parts, points);
    }

    /** μ = rise / slope, undivided. */
    private record Ratio(BigDecimal rise, BigDecimal slope) {
        Ratio(double[] normal, BigDecimal c, double[] from, double[] through) {
            this(c.subtract(dot(normal, from)), dot(normal, through).subtract(dot(normal, from)));
        }

        double mu() {
            if (slope.signum() == 0) return Double.NaN;
            double mu = rise.divide(slope, DIGITS).doubleValue();
            return Double.isFinite(mu) ? mu : Double.NaN;
        }

        Line.PositionOnLine part() {
            if (rise.signum() * slope.signum() < 0) return Line.PositionOnLine.BEHIND;
            boolean beyond = rise.abs().compareTo(slope.abs()) > 0;
            return beyond ? Line.PositionOnLine.BEYOND : Line.PositionOnLine.BETWEEN;
        }

        /** The common point, each coordinate rounded once. */
        double[] point(double[] from, double[] through) {
            var point = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                BigDecimal start = new BigDecimal(from[axis]);
                BigDecimal way = new BigDecimal(through[axis]).subtract(start);
                BigDecimal above = start.multiply(slope).add(way.multiply(rise));
                point[axis] = above.divide(slope, DIGITS).doubleValue();
            }
            return point;
        }
    }

    private static BigDecimal dot(double[] a, double[] b) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++)
            sum = sum.add(new BigDecimal(a[axis]).multiply(new BigDecimal(b[axis])));
        return sum;
    }
}
