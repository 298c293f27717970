package rasterlab.engine.clip.exact;

import java.util.Arrays;
import java.util.Optional;

/**
 * The right answer for one segment, in fractions: one border after another cuts off what is beyond
 * it, with new ends as rational points.
 *
 * <p>A border is a row of coefficients a, b, …, k: the points p with a·p1 + b·p2 + … + k ≥ 0 are
 * within. Works in any number of dimensions. Shares no code with the methods it judges.
 */
public final class ExactClip {
    private static final int CORNERS = 4;

    /** Share of two products; rounding changes their difference by less. */
    private static final double ROUNDED = 1e-15;

    /** Bound of all that underflow changes. */
    private static final double LEAST = 1e-290;

    private static final Ratio ONE = Ratio.of(1);
    private static final Ratio MINUS_ONE = Ratio.of(-1);

    private ExactClip() {}

    /**
     * The part of a plane segment in a window.
     *
     * @param window xmin, ymin, xmax, ymax
     * @param ends x0, y0, x1, y1
     * @return the new ends, each coordinate the double nearest to the exact one; empty where
     *     nothing is left, and where an end is not finite, since there is no such segment
     */
    public static Optional<double[]> plane(double[] window, double[] ends) {
        if (!finite(ends)) return Optional.empty();
        return clip(borders(window), ends);
    }

    /**
     * Whether {@link #plane} leaves anything. It does unless a line parts the two: a border of the
     * window, or the segment's own line with all corners on one side.
     */
    public static boolean meets(double[] window, double[] ends) {
        if (!finite(ends)) return false;
        for (int axis = 0; axis < 2; axis++)
            if (Math.max(ends[axis], ends[axis + 2]) < window[axis]
                    || Math.min(ends[axis], ends[axis + 2]) > window[axis + 2]) return false;
        int sides = 0;
        for (int corner = 0; corner < CORNERS; corner++)
            sides += side(ends, window[corner < 2 ? 0 : 2], window[corner % 2 == 0 ? 1 : 3]);
        return Math.abs(sides) < CORNERS;
    }

    /** The side of the segment's line that a point lies on: 1 to its left, −1, or 0 on it. */
    private static int side(double[] ends, double x, double y) {
        double left = (ends[2] - ends[0]) * (y - ends[1]);
        double right = (ends[3] - ends[1]) * (x - ends[0]);
        if (Math.abs(left - right) > ROUNDED * (Math.abs(left) + Math.abs(right)) + LEAST)
            return left > right ? 1 : -1;
        Ratio[] from = point(ends, 0, 2);
        Ratio[] to = point(ends, 2, 2);
        Ratio up = Ratio.of(y).minus(from[1]);
        Ratio across = Ratio.of(x).minus(from[0]);
        return to[0].minus(from[0]).times(up).compareTo(to[1].minus(from[1]).times(across));
    }

    private static Ratio[][] borders(double[] window) {
        Ratio o = Ratio.ZERO;
        return new Ratio[][] {
            {ONE, o, Ratio.of(-window[0])},
            {o, ONE, Ratio.of(-window[1])},
            {MINUS_ONE, o, Ratio.of(window[2])},
            {o, MINUS_ONE, Ratio.of(window[3])}
        };
    }

    /**
     * The part of a plane segment in a convex window with an area.
     *
     * @param corners x and y of each in turn, in either direction
     * @param ends x0, y0, x1, y1
     * @return as {@link #plane}
     */
    public static Optional<double[]> convex(double[] corners, double[] ends) {
        if (!finite(ends)) return Optional.empty();
        int n = corners.length / 2;
        var borders = new Ratio[n][];
        Ratio area = Ratio.ZERO;
        for (int i = 0; i < n; i++) {
            Ratio[] from = point(corners, 2 * i, 2);
            Ratio[] to = point(corners, 2 * ((i + 1) % n), 2);
            Ratio a = from[1].minus(to[1]);
            Ratio b = to[0].minus(from[0]);
            Ratio k = Ratio.ZERO.minus(a.times(from[0])).minus(b.times(from[1]));
            borders[i] = new Ratio[] {a, b, k};
            area = area.plus(from[0].times(to[1]).minus(to[0].times(from[1])));
        }
        if (area.signum() < 0)
            for (Ratio[] border : borders)
                for (int i = 0; i < 3; i++) border[i] = Ratio.ZERO.minus(border[i]);
        return clip(borders, ends);
    }

    /**
     * The part of a segment in the normalised view volume.
     *
     * @param zmin distance of the nearest plane
     * @param ends x0, y0, z0, x1, y1, z1
     * @return as {@link #plane}
     */
    public static Optional<double[]> volume(double zmin, double[] ends) {
        if (!finite(ends)) return Optional.empty();
        Ratio o = Ratio.ZERO;
        return clip(
                new Ratio[][] {
                    {MINUS_ONE, o, ONE, o},
                    {ONE, o, ONE, o},
                    {o, MINUS_ONE, ONE, o},
                    {o, ONE, ONE, o},
                    {o, o, MINUS_ONE, ONE},
                    {o, o, ONE, Ratio.of(-zmin)}
                },
                ends);
    }

    private static boolean finite(double[] numbers) {
        for (double number : numbers) if (!Double.isFinite(number)) return false;
        return true;
    }

    private static Optional<double[]> clip(Ratio[][] borders, double[] ends) {
        return left(borders, ends).map(ExactClip::rounded);
    }

    private static double[] rounded(Ratio[][] left) {
        return Arrays.stream(left).flatMap(Arrays::stream).mapToDouble(Ratio::toDouble).toArray();
    }

    /** The new ends; empty where nothing is left. */
    private static Optional<Ratio[][]> left(Ratio[][] borders, double[] ends) {
        int dimension = ends.length / 2;
        Ratio[] from = point(ends, 0, dimension);
        Ratio[] to = point(ends, dimension, dimension);
        for (Ratio[] border : borders) {
            Ratio atFrom = value(border, from);
            Ratio atTo = value(border, to);
            if (atFrom.signum() < 0 && atTo.signum() < 0) return Optional.empty();
            if (atFrom.signum() < 0) from = crossing(from, atFrom, to, atTo);
            else if (atTo.signum() < 0) to = crossing(from, atFrom, to, atTo);
        }
        return Optional.of(new Ratio[][] {from, to});
    }

    private static Ratio[] point(double[] numbers, int start, int dimension) {
        var point = new Ratio[dimension];
        for (int i = 0; i < dimension; i++) point[i] = Ratio.of(numbers[start + i]);
        return point;
    }

    private static Ratio value(Ratio[] border, Ratio[] point) {
        Ratio sum = border[point.length];
        for (int i = 0; i < point.length; i++)
            if (border[i].signum() != 0) sum = sum.plus(border[i].times(point[i]));
        return sum;
    }

    private static Ratio[] crossing(Ratio[] from, Ratio atFrom, Ratio[] to, Ratio atTo) {
        Ratio t = atFrom.by(atFrom.minus(atTo));
        var point = new Ratio[from.length];
        for (int i = 0; i < point.length; i++)
            point[i] = from[i].plus(to[i].minus(from[i]).times(t));
        return point;
    }
}
