package rasterlab.engine.polygon;

import java.math.BigDecimal;

/**
 * Whether a point lies in a polygon, in decimal numbers of any length.
 *
 * <p>A point on an edge is inside. Otherwise the edges that cross the horizontal through it are
 * counted by where they cross: an edge with its lower end on or below and its upper end above the
 * point crosses at {@code x0 + (y − y0)·(x1 − x0)/(y1 − y0)}; the division is multiplied away. The
 * point is inside when an odd number cross to its right. Shares no code with the methods it judges.
 */
public final class ExactMembership implements Membership.PointClassifier {
    private final BigDecimal[] x;
    private final BigDecimal[] y;

    public ExactMembership(Points corners) {
        x = decimals(corners.xs());
        y = decimals(corners.ys());
    }

    private static BigDecimal[] decimals(double[] values) {
        var exact = new BigDecimal[values.length];
        for (int i = 0; i < values.length; i++) exact[i] = new BigDecimal(values[i]);
        return exact;
    }

    @Override
    public boolean contains(double pointX, double pointY) {
        var px = new BigDecimal(pointX);
        var py = new BigDecimal(pointY);
        boolean inside = false;
        for (int i = 0; i < x.length; i++) {
            int j = (i + 1) % x.length;
            if (between(x[i], px, x[j]) && between(y[i], py, y[j]) && level(i, j, px, py) == 0)
                return true;
            boolean above = y[i].compareTo(py) > 0;
            if (above == y[j].compareTo(py) > 0) continue;
            // The edge is right of the point where level has the sign of the way up.
            if (level(i, j, px, py) > 0 == !above) inside = !inside;
        }
        return inside;
    }

    /** Sign of (x0 − px)·(y1 − y0) + (py − y0)·(x1 − x0). */
    private int level(int i, int j, BigDecimal px, BigDecimal py) {
        BigDecimal across = x[i].subtract(px).multiply(y[j].subtract(y[i]));
        BigDecimal along = py.subtract(y[i]).multiply(x[j].subtract(x[i]));
        return across.add(along).signum();
    }

    private static boolean between(BigDecimal a, BigDecimal p, BigDecimal b) {
        return p.compareTo(a.min(b)) >= 0 && p.compareTo(a.max(b)) <= 0;
    }
}
