package rasterlab.engine.polygon.triangle;

import java.util.Map;

/**
 * Maps the triangle to the unit simplex (0, 0), (1, 0), (0, 1) and looks there.
 *
 * <p>With c moved to the origin the corners a and b are the rows of M = [ax ay; bx by], and {@code
 * (u v) = (x y)·M⁻¹}, {@code M⁻¹ = [by −ay; −bx ax] / (ax·by − ay·bx)}. Inside where u ≥ 0, v ≥ 0
 * and u + v ≤ 1.
 *
 * <p>A triangle without area has no inverse and is refused. The division rounds, so points on the
 * sides fall to either.
 *
 * <p>Source: D. Chistyakov's suggestion of 1999, in A. V. Kazantsev, Foundations of computer
 * graphics for programmers, Kazan, 2005, ch. 1.
 */
final class Simplex implements SteppedTriangleTest {
    @Override
    public boolean contains(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return new Walk(ax, ay, bx, by, cx, cy, x, y).drain();
    }

    @Override
    public SideWalk walk(
            double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
        return new Walk(ax, ay, bx, by, cx, cy, x, y);
    }

    @Override
    public String valueFormula() {
        return "u, v and u + v in turn; inside where u ≥ 0, v ≥ 0 and u + v ≤ 1";
    }

    /** u is 0 on the side c–b, v on c–a, and u + v is 1 on a–b. */
    @Override
    public int[] corners(int side) {
        return side == 2 ? new int[] {0, 1} : new int[] {2, 1 - side};
    }

    private static final class Walk extends SideWalk {
        private final double ux;
        private final double uy;
        private final double vx;
        private final double vy;
        private final double px;
        private final double py;
        private final double area;
        private double u;
        private double v;
        private long divisions;

        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
            ux = ax - cx;
            uy = ay - cy;
            vx = bx - cx;
            vy = by - cy;
            px = x - cx;
            py = y - cy;
            area = ux * vy - uy * vx;
            spend(2, 7);
            if (area == 0 || !Double.isFinite(area))
                throw new IllegalArgumentException(
                        "the triangle's doubled area must be neither 0 nor beyond doubles, got "
                                + area);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> u = byArea(px * vy - py * vx);
                case 1 -> v = byArea(py * ux - px * uy);
                default -> sum();
            };
        }

        private double byArea(double product) {
            spend(2, 1);
            divisions++;
            return product / area;
        }

        private double sum() {
            spend(0, 1);
            return u + v;
        }

        @Override
        boolean outside(int side, double value) {
            return side < 2 ? value < 0 : !(value <= 1);
        }

        @Override
        public Map<String, Long> operations() {
            Map<String, Long> counts = super.operations();
            counts.put("divisions", divisions);
            return counts;
        }
    }
}
