package rasterlab.engine.polygon.inside;

/**
 * Counts how often the polygon winds round the point.
 *
 * <p>An edge that crosses the point's height upward with the point on its left adds 1, one that
 * crosses downward with the point on its right takes 1 off; the side is the sign of {@code (x1 −
 * x0)·(y − y0) − (x − x0)·(y1 − y0)}. Inside where the sum is not 0.
 *
 * <p>Where a polygon covers itself twice the sum is 2 or 0, depending on the direction, while a ray
 * crosses an even number of edges: there this method follows another rule than the contract. Points
 * on the boundary fall to either, and near an edge rounding decides.
 *
 * <p>Source: K. Hormann, A. Agathos, The point in polygon problem for arbitrary polygons,
 * Computational Geometry 20, 2001, pp. 131–144.
 */
final class Winding implements SteppedPolygonTest {
    @Override
    public EdgeWalk walk(double[] polygonX, double[] polygonY, double x, double y) {
        return new Walk(polygonX, polygonY, x, y);
    }

    @Override
    public String countFormula() {
        return "1 for an edge going up with the point on its left, −1 for one going down with it on"
                + " its right; inside when not 0";
    }

    private static final class Walk extends EdgeWalk {
        Walk(double[] polygonX, double[] polygonY, double x, double y) {
            super(polygonX, polygonY, x, y);
        }

        @Override
        int crossing(double fromX, double fromY, double toX, double toY) {
            boolean up = fromY <= y && toY > y;
            boolean down = fromY > y && toY <= y;
            if (!up && !down) return 0;
            double side = (toX - fromX) * (y - fromY) - (x - fromX) * (toY - fromY);
            return up ? (side > 0 ? 1 : 0) : side < 0 ? -1 : 0;
        }

        @Override
        public boolean inside() {
            return count() != 0;
        }
    }
}
