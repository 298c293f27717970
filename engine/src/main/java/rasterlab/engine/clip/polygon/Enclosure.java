package rasterlab.engine.clip.polygon;

import java.math.BigDecimal;
import java.util.Optional;

/** The result where the subject's boundary does not pass the window's rim. */
final class Enclosure {
    private static final BigDecimal THREE = BigDecimal.valueOf(3);

    private Enclosure() {}

    /** The subject where it lies inside the window, the window where it lies inside the subject. */
    static Optional<Ring> of(Ring window, Ring subject) {
        for (int side = 0; side < window.size(); side++)
            if (window.side(side, subject.x(0), subject.y(0)) <= 0)
                return holdsCenter(window, subject) ? Optional.of(window) : Optional.empty();
        return Optional.of(subject);
    }

    /**
     * Whether the centre c of the window's first three corners, strictly inside it, lies inside the
     * subject: whether a ray from it to the right passes the boundary an odd number of times. All
     * is computed for 3·c, without rounding; no edge holds c.
     */
    private static boolean holdsCenter(Ring window, Ring subject) {
        BigDecimal x = BigDecimal.ZERO;
        BigDecimal y = BigDecimal.ZERO;
        for (int i = 0; i < 3; i++) {
            x = x.add(new BigDecimal(window.x(i)));
            y = y.add(new BigDecimal(window.y(i)));
        }
        boolean inside = false;
        boolean above = above(subject, 0, y);
        for (int i = 0; i < subject.size(); i++) {
            boolean nextAbove = above(subject, i + 1, y);
            if (above != nextAbove && leftOf(subject, i, x, y) == nextAbove) inside = !inside;
            above = nextAbove;
        }
        return inside;
    }

    private static boolean above(Ring subject, int corner, BigDecimal y) {
        return tripled(subject.y(corner)).compareTo(y) > 0;
    }

    /** Whether c lies left of the edge's direction. */
    private static boolean leftOf(Ring subject, int edge, BigDecimal x, BigDecimal y) {
        BigDecimal ax = tripled(subject.x(edge));
        BigDecimal ay = tripled(subject.y(edge));
        BigDecimal left = tripled(subject.x(edge + 1)).subtract(ax).multiply(y.subtract(ay));
        BigDecimal right = tripled(subject.y(edge + 1)).subtract(ay).multiply(x.subtract(ax));
        return left.compareTo(right) > 0;
    }

    private static BigDecimal tripled(double coordinate) {
        return new BigDecimal(coordinate).multiply(THREE);
    }
}
