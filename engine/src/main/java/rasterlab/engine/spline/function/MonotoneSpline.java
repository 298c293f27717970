package rasterlab.engine.spline.function;

import rasterlab.contract.SplineEnds;

/**
 * A piecewise cubic that never overshoots: between two knots it stays between their values.
 *
 * <p>It starts from the slopes of parabolas through three neighbouring points, k[i] = λ·δ[i−1] +
 * μ·δ[i], where neighbouring secants have one sign, and 0 where they have not. Then piece by piece,
 * with α = k[i]/δ[i] and β = k[i+1]/δ[i]: where α² + β² &gt; 9 both slopes are pulled back to that
 * circle, inside which the piece is monotone. The second derivative jumps.
 *
 * <p>Ends: given slopes are limited too; natural takes k[0] = (3·δ[0] − k[1])/2; not-a-knot the
 * slope of the parabola through three points; periodic treats the first knot as an inner one.
 *
 * <p>Source: F. N. Fritsch, R. E. Carlson, Monotone piecewise cubic interpolation, SIAM Journal on
 * Numerical Analysis 17(2), 1980, pp. 238–246.
 */
public final class MonotoneSpline implements SteppedSpline {
    @Override
    public Promise promise() {
        return Promise.SHAPE;
    }

    @Override
    public double[] coefficients(double[] x, double[] y, SplineEnds ends) {
        var knots = new Knots(x, y, ends);
        var walk = new Walk(knots, ends);
        while (walk.advance()) continue;
        return knots.sloping(walk.slopes);
    }

    @Override
    public SplineWalk walk(double[] x, double[] y, SplineEnds ends) {
        return new Walk(new Knots(x, y, ends), ends);
    }

    @Override
    public String decisionFormula() {
        return "α² + β², α = k[i]/δ[i], β = k[i+1]/δ[i]; the slopes are pulled back where it is"
                + " above 9";
    }

    private static final class Walk implements SplineWalk {
        private final Knots knots;
        private final boolean periodic;
        private final double[] slopes;
        private int piece = -1;
        private double decision;
        private boolean limited;
        private long limitedPieces;

        Walk(Knots knots, SplineEnds ends) {
            this.knots = knots;
            periodic = ends.kind() == SplineEnds.Kind.PERIODIC;
            slopes = FirstSlopes.of(knots, ends);
        }

        @Override
        public boolean advance() {
            if (piece == knots.pieces - 1) return false;
            piece++;
            limit(knots.secant[piece]);
            if (limited) limitedPieces++;
            if (periodic && piece == knots.pieces - 1) join();
            return true;
        }

        private void limit(double secant) {
            double alpha = secant == 0 ? 0 : slopes[piece] / secant;
            double beta = secant == 0 ? 0 : slopes[piece + 1] / secant;
            decision = alpha * alpha + beta * beta;
            limited = decision > 9;
            if (secant == 0) {
                slopes[piece] = 0;
                slopes[piece + 1] = 0;
            } else if (limited) {
                double back = 3 * Math.abs(secant) / Math.hypot(slopes[piece], slopes[piece + 1]);
                slopes[piece] *= back;
                slopes[piece + 1] *= back;
            }
        }

        /**
         * The first and the last knot are one: of their two slopes the smaller suits both pieces.
         */
        private void join() {
            int last = knots.pieces;
            boolean first = Math.abs(slopes[0]) < Math.abs(slopes[last]);
            double smaller = first ? slopes[0] : slopes[last];
            slopes[0] = smaller;
            slopes[last] = smaller;
        }

        @Override
        public int index() {
            return piece;
        }

        @Override
        public String phase() {
            return limited ? "limit" : "keep";
        }

        @Override
        public double decision() {
            return decision;
        }

        @Override
        public long exceptions() {
            return limitedPieces;
        }
    }
}
