package rasterlab.engine.polygon.triangle;

import java.util.Map;
import java.util.TreeMap;
import rasterlab.engine.range.Finite;

/**
 * One way round a triangle, side by side, for one point.
 *
 * <p>A new walk stands before the first side. It ends at the side that tells the point to be
 * outside, or at the third.
 */
public abstract class SideWalk {
    private static final int SIDES = 3;

    final double ax;
    final double ay;
    final double bx;
    final double by;
    final double cx;
    final double cy;
    final double x;
    final double y;
    private int side = -1;
    private double value;
    private boolean outside;
    private int multiplications;
    private int additions;

    /**
     * @throws IllegalArgumentException if a coordinate is NaN or infinite
     */
    SideWalk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        requireFinite(ax, ay, bx, by, cx, cy, x, y);
        this.ax = ax;
        this.ay = ay;
        this.bx = bx;
        this.by = by;
        this.cx = cx;
        this.cy = cy;
        this.x = x;
        this.y = y;
    }

    /** Asks the next side; false when there is none, or the answer is settled. */
    public final boolean advance() {
        if (outside || side + 1 == SIDES) return false;
        side++;
        value = ask(side);
        outside = outside(side, value);
        return true;
    }

    /** The verdict of a side, 0 to 2, on the point. */
    abstract double ask(int side);

    /** Whether that, after what earlier sides said, tells the point to be outside. */
    abstract boolean outside(int side, double value);

    /** The answer, once {@link #advance} has returned false. */
    public final boolean inside() {
        return !outside;
    }

    /** Number of the side asked last, 0 being the first. */
    public final int side() {
        return side;
    }

    /** The value of the side asked last; the method tells by which formula. */
    public final double value() {
        return value;
    }

    /** Adds to what the walk has cost; called beside the formula. */
    final void spend(int multiplications, int additions) {
        this.multiplications += multiplications;
        this.additions += additions;
    }

    /** The operations so far: name in the plural to number; subtractions are additions. */
    public Map<String, Long> operations() {
        return new TreeMap<>(
                Map.of(
                        "sides asked", side + 1L,
                        "multiplications", (long) multiplications,
                        "additions", (long) additions));
    }

    /** The sides a–c, c–b, b–a in turn, as the sign methods ask them. */
    static int[] backwards(int side) {
        return new int[] {(SIDES - side) % SIDES, SIDES - 1 - side};
    }

    /** Goes to the end. */
    final boolean drain() {
        while (advance())
            ;
        return inside();
    }

    /**
     * Passes if all are finite: then their sum times 0 is 0, unless it overflows.
     *
     * @throws IllegalArgumentException naming the value that is not
     */
    static void requireFinite(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        if ((ax + ay + bx + by + cx + cy + x + y) * 0 != 0)
            Finite.require("coordinate", ax, ay, bx, by, cx, cy, x, y);
    }
}
