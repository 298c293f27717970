package rasterlab.engine.geometry;

import java.math.BigDecimal;
import rasterlab.engine.range.Finite;

/**
 * The sign of (ax − cx)·(by − cy) − (ay − cy)·(bx − cx), whatever it costs.
 *
 * <p>Each difference is split into the double nearest to it and the error of that, which is a
 * double too; the products of those parts are summed as an {@link Expansion}. Where a part is so
 * large or so small that a product could leave the range of doubles, decimal numbers of any length
 * take over.
 */
final class ExactOrientation {
    /** Parts between these bounds have products with errors that are doubles. */
    private static final double SMALLEST_PART = 0x1p-450;

    private static final double LARGEST_PART = 0x1p500;

    private ExactOrientation() {}

    static int of(double ax, double ay, double bx, double by, double cx, double cy) {
        double acx = ax - cx;
        double acy = ay - cy;
        double bcx = bx - cx;
        double bcy = by - cy;
        double acxLow = differenceError(ax, cx, acx);
        double acyLow = differenceError(ay, cy, acy);
        double bcxLow = differenceError(bx, cx, bcx);
        double bcyLow = differenceError(by, cy, bcy);
        if (!(fits(acx) && fits(acy) && fits(bcx) && fits(bcy))
                || !(fits(acxLow) && fits(acyLow) && fits(bcxLow) && fits(bcyLow)))
            return ofDecimals(ax, ay, bx, by, cx, cy);
        var det = new Expansion(16);
        det.addProduct(acxLow, bcyLow);
        det.addProduct(-acyLow, bcxLow);
        det.addProduct(acxLow, bcy);
        det.addProduct(acx, bcyLow);
        det.addProduct(-acyLow, bcx);
        det.addProduct(-acy, bcxLow);
        det.addProduct(acx, bcy);
        det.addProduct(-acy, bcx);
        return det.sign();
    }

    /** a − b − (a ⊖ b), exactly, unless a ⊖ b overflows. Source: D. E. Knuth's two-sum. */
    private static double differenceError(double a, double b, double difference) {
        double bVirtual = a - difference;
        double aVirtual = difference + bVirtual;
        return (a - aVirtual) + (bVirtual - b);
    }

    private static boolean fits(double part) {
        double size = Math.abs(part);
        return size == 0 || (size >= SMALLEST_PART && size <= LARGEST_PART);
    }

    private static int ofDecimals(
            double ax, double ay, double bx, double by, double cx, double cy) {
        Finite.require("coordinate", ax, ay, bx, by, cx, cy);
        var x = new BigDecimal(cx);
        var y = new BigDecimal(cy);
        BigDecimal left = new BigDecimal(ax).subtract(x).multiply(new BigDecimal(by).subtract(y));
        BigDecimal right = new BigDecimal(ay).subtract(y).multiply(new BigDecimal(bx).subtract(x));
        return left.compareTo(right);
    }
}
