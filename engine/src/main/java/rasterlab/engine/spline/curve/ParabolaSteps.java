package rasterlab.engine.spline.curve;

/**
 * Where to put the corners of a polyline on a cubic so that all chords are equally far from it: at
 * equal steps of the integral of √κ over the length, κ being the curvature.
 *
 * <p>A chord of length s is about κs²/8 from its curve, so ½·∫√κ ds/√flatness chords are needed.
 * The cubic is taken for parabolas, each near enough, on which that integral has a closed form; it
 * and its inverse are approximated by {@link #integral} and {@link #inverse} to within a few
 * percent. Nothing here promises that a chord is near the curve.
 *
 * <p>Source: R. Levien, Flattening quadratic Béziers, 2019, with both approximations and the
 * treatment of cusps; the count of parabolas: T. W. Sederberg, Computer aided geometric design
 * course notes, 2012, whose bound √3/36·|P₃ − 3P₂ + 3P₁ − P₀| it is.
 */
final class ParabolaSteps {
    /** Share of the flatness that the parabolas may be away from the cubic. */
    static final double OF_PARABOLAS = 0.1;

    private static final double D = 0.67;
    private static final double B = 0.39;

    private static final int MOST_PARABOLAS = 1 << 16;

    private final CubicPiece cubic;
    private final double rootFlatness;
    private final int parabolas;
    private final double[] sums;
    private final double[] first;
    private final double[] last;

    /** Chords that the curve takes, not rounded. */
    private final double chords;

    /**
     * @param flatness in pixels
     */
    ParabolaSteps(CubicPiece cubic, double flatness) {
        this.cubic = cubic;
        rootFlatness = Math.sqrt(flatness);
        double count =
                Math.ceil(Math.cbrt(cubic.third() * Math.sqrt(3) / (36 * OF_PARABOLAS * flatness)));
        parabolas = (int) Math.max(1, Math.min(MOST_PARABOLAS, count));
        sums = new double[parabolas + 1];
        first = new double[parabolas];
        last = new double[parabolas];
        for (int i = 0; i < parabolas; i++) sums[i + 1] = sums[i] + measured(i);
        chords = 0.5 * sums[parabolas] / rootFlatness;
    }

    /** The integral over one parabola; keeps where it begins and ends on the parabola y = x². */
    private double measured(int i) {
        double from = (double) i / parabolas;
        double to = (i + 1.0) / parabolas;
        double chordX = cubic.x(to) - cubic.x(from);
        double chordY = cubic.y(to) - cubic.y(from);
        // twice the second difference of the parabola's points, its axis
        double axisX = 0.5 * (to - from) * (cubic.turnX(from) - cubic.turnX(to));
        double axisY = 0.5 * (to - from) * (cubic.turnY(from) - cubic.turnY(to));
        double cross = chordX * axisY - chordY * axisX;
        double middle = (chordX * axisX + chordY * axisY) / (2 * cross);
        double half = (axisX * axisX + axisY * axisY) / (2 * cross);
        double x0 = middle + half;
        double x2 = middle - half;
        double scale = Math.abs(cross / (Math.hypot(axisX, axisY) * (x2 - x0)));
        first[i] = integral(x0);
        last[i] = integral(x2);
        double root = Math.sqrt(scale);
        double along = Math.abs(last[i] - first[i]);
        if (!(root < Double.POSITIVE_INFINITY) || !(along < Double.POSITIVE_INFINITY)) return 0;
        if (x0 * x2 >= 0) return along * root;
        // a cusp: nothing is finer than the flatness
        return rootFlatness * along / integral(rootFlatness / root);
    }

    /** How many chords make all equally near, at least 1. */
    int count() {
        return count(1);
    }

    /**
     * The number of steps where they have but a share of the flatness.
     *
     * @param share above 0, at most 1
     */
    int count(double share) {
        double wanted = chords / Math.sqrt(share);
        return wanted >= 1 ? (int) Math.ceil(Math.min(wanted, Flatness.MOST_SEGMENTS)) : 1;
    }

    /** u of the corners for that many chords, from 0 to 1. */
    double[] corners(int count) {
        var u = new double[count + 1];
        int i = 0;
        for (int k = 1; k < count; k++) {
            double target = k * sums[parabolas] / count;
            while (i < parabolas - 1 && sums[i + 1] < target) i++;
            u[k] = (i + within(i, target)) / parabolas;
        }
        u[count] = 1;
        return u;
    }

    private double within(int i, double target) {
        double whole = sums[i + 1] - sums[i];
        if (!(whole > 0)) return 0.5;
        double share = Math.min(1, (target - sums[i]) / whole);
        double from = inverse(first[i]);
        double to = inverse(last[i]);
        double at = inverse(first[i] + share * (last[i] - first[i]));
        return Math.max(0, Math.min(1, (at - from) / (to - from)));
    }

    /** The point of the parabola that stands for the cubic at u: x at 0, y at 1. */
    double[] onParabola(double u) {
        int i = (int) Math.min(parabolas - 1.0, u * parabolas);
        double from = (double) i / parabolas;
        double to = (i + 1.0) / parabolas;
        double s = u * parabolas - i;
        double bow = s * (1 - s) * 0.5 * (to - from);
        return new double[] {
            (1 - s) * cubic.x(from) + s * cubic.x(to) + bow * (cubic.turnX(from) - cubic.turnX(to)),
            (1 - s) * cubic.y(from) + s * cubic.y(to) + bow * (cubic.turnY(from) - cubic.turnY(to))
        };
    }

    /** About ∫ (1 + 4x²)^(−¼) dx. */
    private static double integral(double x) {
        return x / (1 - D + Math.sqrt(Math.sqrt(D * D * D * D + 0.25 * x * x)));
    }

    /** The inverse of {@link #integral}, about. */
    private static double inverse(double a) {
        return a * (1 - B + Math.sqrt(B * B + 0.25 * a * a));
    }
}
