package rasterlab.engine.spline.curve;

import java.util.Arrays;
import rasterlab.contract.Curve;
import rasterlab.contract.CurvePoints;

/**
 * The fewest chords with their ends on the curve, or nearly: each reaches as far as the flatness
 * lets it.
 *
 * <p>A chord that starts farther back never has to end sooner, so reaching as far as possible each
 * time needs no more chords than any other choice. How far that is, is found by trial: over a width
 * h the curve is about κ·h²/8 from its chord, so from a distance found the next width follows by a
 * root, until the distance is from {@value #ENOUGH} to 1 times the flatness. Where the first chord
 * ends is guessed from {@link ParabolaSteps}, each later one from the one before. A chord is drawn
 * only after it was measured on the cubic itself, so the flatness holds whatever the guesses say,
 * at cusps, turns and inflections too. Degrees above 3 are left to {@link AdaptiveCurve}.
 *
 * <p>Source: R. Levien, Flattening quadratic Béziers, 2019, for the count; reaching as far as a
 * measured bound allows is derived here.
 */
public final class FewestCurve implements SteppedCurve {
    private static final double ENOUGH = 0.96;

    /** Trials after which what was found will do. */
    private static final int TRIALS = 12;

    /** Aims a little below the flatness, which the next trial then need not correct. */
    private static final double AIM = 0.99;

    private final AdaptiveCurve halving = new AdaptiveCurve();

    @Override
    public void at(Curve curve, double[] t, CurvePoints out) {
        halving.at(curve, t, out);
    }

    @Override
    public void flatten(Curve curve, double flatness, CurvePoints out) {
        walk(curve, flatness).drain(out);
    }

    @Override
    public CurveWalk walk(Curve curve, double flatness) {
        return curve.degree() > 3 ? halving.walk(curve, flatness) : new Walk(curve, flatness);
    }

    @Override
    public String decisionFormula() {
        return "distance of the curve from the chord, in pixels; just below the flatness but for the"
                + " last chord";
    }

    private static final class Walk extends CornersWalk {
        private double[] corners = {};
        private long trials;

        Walk(Curve curve, double flatness) {
            super(curve, flatness);
        }

        @Override
        int chosen() {
            double width = 1.0 / new ParabolaSteps(cubic, left).count();
            corners = new double[8];
            int count = 0;
            double from = 0;
            while (from < 1) {
                double to = reached(from, width);
                width = to - from;
                from = to;
                if (++count == corners.length) corners = Arrays.copyOf(corners, 2 * count);
                corners[count] = from;
            }
            return count;
        }

        /** Where a chord from there ends, as far off as some trials tell; always farther on. */
        private double reached(double from, double width) {
            double near = from;
            double far = Double.POSITIVE_INFINITY;
            double to = Math.min(1, from + width);
            for (int trial = 0; trial < TRIALS || near == from; trial++) {
                trials++;
                double distance = cubic.fromChord(from, to);
                if (distance <= left || to <= Math.nextUp(from)) near = to;
                else far = to;
                if (near == 1 || near == to && distance >= ENOUGH * left) return near;
                to = next(from, near, far, (to - from) * Math.sqrt(AIM * left / distance));
                if (to == near) return near;
            }
            return near;
        }

        /** The guess where it lies between what is known to be near and too far; else half way. */
        private static double next(double from, double near, double far, double width) {
            double farthest = Math.min(1, far);
            double guess = from + width;
            if (guess > near && guess < farthest) return guess;
            if (far == Double.POSITIVE_INFINITY) return Math.min(1, near + 2 * (near - from));
            return near + (farthest - near) / 2;
        }

        @Override
        double[] corners() {
            return corners;
        }

        /** The chords that were measured, those that are drawn too. */
        @Override
        public long splits() {
            return trials;
        }
    }
}
