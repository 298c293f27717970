package rasterlab.engine.polygon.triangle;

import java.util.List;
import java.util.Map;

/**
 * Turns the plane about the point until a corner lies on the Oy axis; inside where the two other
 * corners then have x of different signs, for each corner in turn.
 *
 * <p>The corner at distance r and angle t from Oy, sin t = vx/r, is turned by t: {@code x' = x·cos
 * t − y·sin t}, {@code y' = x·sin t + y·cos t}. A corner with x' = 0 is on the axis too; the point
 * is on that side where the two have y of different signs.
 *
 * <p>sin and cos are rounded, so x' is hardly ever exactly 0, and a point on a side falls to
 * either.
 */
final class Rotation implements SteppedTriangleTest {
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
        return "x' of one of the two other corners, times the sign of the other's, or y' likewise where"
                + " x' is 0; inside where none is positive";
    }

    @Override
    public int[] corners(int side) {
        return new int[] {side, side};
    }

    private static final class Walk extends SideWalk {
        Walk(double ax, double ay, double bx, double by, double cx, double cy, double x, double y) {
            super(ax, ay, bx, by, cx, cy, x, y);
        }

        @Override
        double ask(int side) {
            return switch (side) {
                case 0 -> turn(ax - x, ay - y, bx - x, by - y, cx - x, cy - y);
                case 1 -> turn(bx - x, by - y, cx - x, cy - y, ax - x, ay - y);
                default -> turn(cx - x, cy - y, ax - x, ay - y, bx - x, by - y);
            };
        }

        /** The turn with v on the Oy axis, positive where p and q lie on one side of it. */
        private double turn(double vx, double vy, double px, double py, double qx, double qy) {
            spend(6, 9);
            double angle = StrictMath.atan2(vx, vy);
            double sin = StrictMath.sin(angle);
            double cos = StrictMath.cos(angle);
            double vTurned = vx * sin + vy * cos;
            double pTurned = px * cos - py * sin;
            double qTurned = qx * cos - qy * sin;
            if (pTurned == 0) return along(px, py, sin, cos) * Math.signum(vTurned);
            if (qTurned == 0) return along(qx, qy, sin, cos) * Math.signum(vTurned);
            return pTurned * Math.signum(qTurned);
        }

        private double along(double px, double py, double sin, double cos) {
            spend(2, 1);
            return px * sin + py * cos;
        }

        @Override
        boolean outside(int side, double value) {
            return value > 0;
        }

        /** One angle for each side. */
        @Override
        public Map<String, Long> operations() {
            Map<String, Long> counts = super.operations();
            for (String function : List.of("arc tangents", "sines", "cosines"))
                counts.put(function, side() + 1L);
            return counts;
        }
    }
}
