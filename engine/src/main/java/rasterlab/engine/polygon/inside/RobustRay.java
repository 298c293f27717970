package rasterlab.engine.polygon.inside;

import rasterlab.engine.geometry.Orientation;

/**
 * Counts the edges that a ray to the right meets, by exact signs instead of a division.
 *
 * <p>An edge with one end on or below the ray and the other above it is met where the point lies on
 * its left as it goes up, by {@link Orientation}. A point that lies on the line of an edge and
 * between its ends is on the boundary: inside, and no more need be counted.
 *
 * <p>Source: exact signs after J. R. Shewchuk, Adaptive precision floating-point arithmetic and
 * fast robust geometric predicates, Discrete & Computational Geometry 18, 1997, pp. 305–363.
 */
public final class RobustRay implements SteppedPolygonTest {
    @Override
    public EdgeWalk walk(double[] polygonX, double[] polygonY, double x, double y) {
        return new Walk(polygonX, polygonY, x, y);
    }

    @Override
    public String countFormula() {
        return "edges with one end at or below y, the other above it, and the point on their left"
                + " going up; inside when odd or on an edge";
    }

    private static final class Walk extends EdgeWalk {
        private boolean onEdge;

        Walk(double[] polygonX, double[] polygonY, double x, double y) {
            super(polygonX, polygonY, x, y);
        }

        @Override
        int crossing(double fromX, double fromY, double toX, double toY) {
            if (y < Math.min(fromY, toY) || y > Math.max(fromY, toY)) return 0;
            if (x > Math.max(fromX, toX)) return 0;
            int side = Orientation.of(fromX, fromY, toX, toY, x, y);
            if (side == 0 && x >= Math.min(fromX, toX)) {
                onEdge = true;
                return 0;
            }
            if (fromY <= y && toY > y) return side > 0 ? 1 : 0;
            if (toY <= y && fromY > y) return side < 0 ? 1 : 0;
            return 0;
        }

        @Override
        boolean settled() {
            return onEdge;
        }

        @Override
        public boolean inside() {
            return onEdge || (count() & 1) == 1;
        }
    }
}
