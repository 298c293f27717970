package rasterlab.engine.clip.polygon;

import java.math.BigDecimal;
import rasterlab.engine.clip.Fraction;
import rasterlab.engine.clip.UnroundedInterval;

/** Where edges pass the lines of a window's sides, and what it took to know. */
final class SideCrossing {
    /** The longest edge, in lengths of the side, whose crossing is computed with rounding. */
    private static final double LONGEST = 1024;

    /** The share of its two terms that a difference must keep to count as precise enough. */
    private static final double ENOUGH = 1.0 / 16;

    private final Ring window;
    private long divisions;
    private long unrounded;

    SideCrossing(Ring window) {
        this.window = window;
    }

    /** Divisions of doubles made so far. */
    long divisions() {
        return divisions;
    }

    /** Crossings computed without rounding so far. */
    long unrounded() {
        return unrounded;
    }

    /** The crossing of the edge p→q, whose ends are on different sides of the line. */
    double[] of(int side, double px, double py, double qx, double qy) {
        double ax = window.x(side);
        double ay = window.y(side);
        double wayX = window.x(side + 1) - ax;
        double wayY = window.y(side + 1) - ay;
        double left = wayX * (py - ay);
        double right = wayY * (px - ax);
        double farLeft = wayX * (qy - ay);
        double farRight = wayY * (qx - ax);
        double d = left - right;
        double e = farLeft - farRight;
        double length = Math.max(Math.abs(wayX), Math.abs(wayY));
        double edge = Math.max(Math.abs(qx - px), Math.abs(qy - py));
        boolean enough =
                Math.abs(d) >= ENOUGH * (Math.abs(left) + Math.abs(right))
                        && Math.abs(e) >= ENOUGH * (Math.abs(farLeft) + Math.abs(farRight))
                        && edge <= LONGEST * length
                        && length >= 0x1p-300
                        && length <= 0x1p300;
        if (!enough) return exactly(side, px, py, qx, qy);
        double t = d / (d - e);
        divisions++;
        // On an upright or level side the crossing has the side's own coordinate.
        return new double[] {
            wayX == 0 ? ax : px + t * (qx - px), wayY == 0 ? ay : py + t * (qy - py)
        };
    }

    private double[] exactly(int side, double px, double py, double qx, double qy) {
        Fraction t = share(side, px, py, qx, qy);
        return new double[] {t.between(px, qx), t.between(py, qy)};
    }

    /** t of the crossing on p→q, without rounding. */
    Fraction share(int side, double px, double py, double qx, double qy) {
        unrounded++;
        double ax = window.x(side);
        double ay = window.y(side);
        double bx = window.x(side + 1);
        double by = window.y(side + 1);
        var d = doubledArea(ax, ay, bx, by, px, py);
        var e = doubledArea(ax, ay, bx, by, qx, qy);
        return d.signum() <= 0
                ? new Fraction(d.negate(), e.subtract(d))
                : new Fraction(d, d.subtract(e));
    }

    /** Twice the area of the triangle a, b, c without rounding, above 0 where it turns left. */
    private static BigDecimal doubledArea(
            double ax, double ay, double bx, double by, double cx, double cy) {
        BigDecimal left = difference(bx, ax).multiply(difference(cy, ay));
        return left.subtract(difference(by, ay).multiply(difference(cx, ax)));
    }

    private static BigDecimal difference(double a, double b) {
        return UnroundedInterval.difference(a, b);
    }
}
