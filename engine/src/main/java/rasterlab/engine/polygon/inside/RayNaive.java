package rasterlab.engine.polygon.inside;

/**
 * Counts the edges that a ray to the right meets, both ends of an edge included.
 *
 * <p>An edge is met where y lies between its ends and {@code x0 + t·(x1 − x0) ≥ x}, t = (y −
 * y0)/(y1 − y0). Inside where the count is odd.
 *
 * <p>A ray through a corner meets two edges there, whether it enters the polygon or only touches
 * it. On a horizontal edge t is 0/0, which meets nothing.
 */
final class RayNaive implements SteppedPolygonTest {
    @Override
    public EdgeWalk walk(double[] polygonX, double[] polygonY, double x, double y) {
        return new Walk(polygonX, polygonY, x, y);
    }

    @Override
    public String countFormula() {
        return "edges with min(y0, y1) ≤ y ≤ max(y0, y1) met at or right of x; inside when odd";
    }

    private static final class Walk extends EdgeWalk {
        Walk(double[] polygonX, double[] polygonY, double x, double y) {
            super(polygonX, polygonY, x, y);
        }

        @Override
        int crossing(double fromX, double fromY, double toX, double toY) {
            if (y < Math.min(fromY, toY) || y > Math.max(fromY, toY)) return 0;
            double t = (y - fromY) / (toY - fromY);
            return fromX + t * (toX - fromX) >= x ? 1 : 0;
        }

        @Override
        public boolean inside() {
            return (count() & 1) == 1;
        }
    }
}
