package rasterlab.engine.polygon.inside;

/**
 * Counts the edges that a ray to the right meets, the upper end of an edge only.
 *
 * <p>As {@link RayNaive}, but a horizontal edge is passed over and an edge whose lower end has the
 * ray's height is not met. So of two edges at a corner the ray meets both where they come from
 * below, none where they come from above, and one where it goes through: the count stays even or
 * odd as it should.
 *
 * <p>Points on the boundary are inside on some edges and outside on others; near an edge the
 * division's rounding decides.
 */
final class RayCrossing implements SteppedPolygonTest {
    @Override
    public EdgeWalk walk(double[] polygonX, double[] polygonY, double x, double y) {
        return new Walk(polygonX, polygonY, x, y);
    }

    @Override
    public String countFormula() {
        return "edges with min(y0, y1) < y ≤ max(y0, y1) met at or right of x; inside when odd";
    }

    private static final class Walk extends EdgeWalk {
        Walk(double[] polygonX, double[] polygonY, double x, double y) {
            super(polygonX, polygonY, x, y);
        }

        @Override
        int crossing(double fromX, double fromY, double toX, double toY) {
            if (y <= Math.min(fromY, toY) || y > Math.max(fromY, toY)) return 0;
            double t = (y - fromY) / (toY - fromY);
            return fromX + t * (toX - fromX) >= x ? 1 : 0;
        }

        @Override
        public boolean inside() {
            return (count() & 1) == 1;
        }
    }
}
