package rasterlab.engine.polygon.triangle;

import java.util.Arrays;

/**
 * Judges many points by one triangle without error, in loops that processors can run for several
 * points at once.
 *
 * <p>Each side has {@code e(x, y) = a·x + b·y + c}, twice the area of the triangle of side and
 * point, counted positive inside. {@code s + t − |s − t|} is twice the lesser of s and t, and taken
 * twice it gives {@code depth}, which has the sign of the least of the three and no jump in it.
 *
 * <p>With R the largest coordinate of the corners and M the largest |a| + |b|, no |e| exceeds 3·R·M
 * for points up to 2·R out, each operation adds at most 2⁻⁵³ of that, and depth is off by less than
 * bound = 256·2⁻⁵³·R·M. A point farther out lies at least |p|/2 from the triangle, whose size is at
 * most 2·√2·R, so its depth is below −A·|p|/(6·R), A being the triangle's doubled area, while the
 * error grows to bound·|p|/(2·R): with bound ≤ A/64 the sign is right there too.
 *
 * <p>So where |depth| exceeds the bound its sign is right. Other points, and all points of
 * triangles too thin, too large or too small for that, are judged by {@link RobustTriangle}. An
 * object may be used by one thread at a time.
 */
public final class TriangleBatch {
    /** Doubts are added up for the places in a block of points. */
    private static final int BLOCK = 512;

    private static final double ROUNDING = 256 * 0x1p-53;
    private static final double LEAST_BOUND = 0x1p-1000;

    private final double ax;
    private final double ay;
    private final double bx;
    private final double by;
    private final double cx;
    private final double cy;
    private final double orientation;
    private final double bound;
    private final boolean thin;
    private final RobustTriangle robust = new RobustTriangle();
    private final double[] blockX = new double[BLOCK];
    private final double[] blockY = new double[BLOCK];
    private final double[] depth = new double[BLOCK];
    private final double[] doubts = new double[BLOCK];

    /**
     * @throws IllegalArgumentException if a coordinate is NaN or infinite
     */
    public TriangleBatch(double ax, double ay, double bx, double by, double cx, double cy) {
        SideWalk.requireFinite(ax, ay, bx, by, cx, cy, 0, 0);
        this.ax = ax;
        this.ay = ay;
        this.bx = bx;
        this.by = by;
        this.cx = cx;
        this.cy = cy;
        double area = (ax - cx) * (by - cy) - (ay - cy) * (bx - cx);
        orientation = area < 0 ? -1 : 1;
        double largest = largest(largest(ax, ay, bx), by, largest(cx, cy, 0));
        double slope =
                largest(
                        Math.abs(by - ay) + Math.abs(bx - ax),
                        Math.abs(cy - by) + Math.abs(cx - bx),
                        Math.abs(ay - cy) + Math.abs(ax - cx));
        bound = ROUNDING * largest * slope;
        thin = !(bound >= LEAST_BOUND && bound <= Math.abs(area) / 64 && Math.abs(area) < 1e300);
    }

    private static double largest(double a, double b, double c) {
        return Math.max(Math.abs(a), Math.max(Math.abs(b), Math.abs(c)));
    }

    /**
     * Sets {@code inside[i]} to whether point (x[i], y[i]) lies in the triangle or on its boundary.
     *
     * @param inside as many as {@code x} and {@code y}
     * @throws IllegalArgumentException if the counts differ, or a coordinate is NaN or infinite
     */
    public void judge(double[] x, double[] y, boolean[] inside) {
        if (y.length != x.length || inside.length != x.length)
            throw new IllegalArgumentException(
                    "x, y and inside must be as many, got "
                            + (x.length + ", " + y.length + ", " + inside.length));
        Arrays.fill(doubts, 0);
        for (int from = 0; from < x.length; from += BLOCK) {
            int count = Math.min(BLOCK, x.length - from);
            measure(x, y, from, count);
            for (int i = 0; i < count; i++) inside[from + i] = depth[i] >= 0;
        }
        if (thin || doubtful()) repair(x, y, inside);
    }

    /**
     * Computes the depths of a block of points, and adds up what doubts there are of their signs: t
     * + |t| is 0 where t = bound − |depth| is negative, and NaN where it is infinite. A short block
     * is filled up with its first point.
     */
    private void measure(double[] x, double[] y, int from, int count) {
        double a0 = orientation * (ay - by);
        double b0 = orientation * (bx - ax);
        double c0 = -(a0 * ax + b0 * ay);
        double a1 = orientation * (by - cy);
        double b1 = orientation * (cx - bx);
        double c1 = -(a1 * bx + b1 * by);
        double a2 = orientation * (cy - ay);
        double b2 = orientation * (ax - cx);
        double c2 = -(a2 * cx + b2 * cy);
        // Only loops over whole arrays that start at 0 are run for several points at once.
        System.arraycopy(x, from, blockX, 0, count);
        System.arraycopy(y, from, blockY, 0, count);
        Arrays.fill(blockX, count, BLOCK, x[from]);
        Arrays.fill(blockY, count, BLOCK, y[from]);
        for (int i = 0; i < depth.length; i++) {
            double e0 = Math.fma(a0, blockX[i], Math.fma(b0, blockY[i], c0));
            double e1 = Math.fma(a1, blockX[i], Math.fma(b1, blockY[i], c1));
            double e2 = Math.fma(a2, blockX[i], Math.fma(b2, blockY[i], c2));
            double lesser = (e0 + e1) - Math.abs(e0 - e1);
            depth[i] = (lesser + e2) - Math.abs(lesser - e2);
            double t = bound - Math.abs(depth[i]);
            doubts[i] += t + Math.abs(t);
        }
    }

    /** Whether some |depth| did not exceed the bound, or was no number. */
    private boolean doubtful() {
        double sum = 0;
        for (double doubt : doubts) sum += doubt;
        return sum != 0;
    }

    /** Judges the points whose depth may have the wrong sign one by one: NaN is one of those. */
    private void repair(double[] x, double[] y, boolean[] inside) {
        for (int from = 0; from < x.length; from += BLOCK) {
            int count = Math.min(BLOCK, x.length - from);
            measure(x, y, from, count);
            for (int i = 0; i < count; i++) {
                double size = Math.abs(depth[i]);
                if (!thin && size > bound && size < Double.POSITIVE_INFINITY) continue;
                inside[from + i] = exactly(x[from + i], y[from + i]);
            }
        }
    }

    private boolean exactly(double x, double y) {
        SideWalk.requireFinite(x, y, 0, 0, 0, 0, 0, 0);
        return robust.contains(ax, ay, bx, by, cx, cy, x, y);
    }
}
