package rasterlab.engine.polygon.triangulation;

/**
 * Joins corner 0 to all others: triangles (0, i, i + 1).
 *
 * <p>Right where the polygon is convex and no other corner lies on the two sides at corner 0; any
 * other is refused. That is so where, seen exactly, every triangle turns the same way, every corner
 * lies between the directions to the first and the last, and no corner turns the other way.
 */
final class Fan implements SteppedTriangulator {
    private static final int MOST_CORNERS = 10_000_000;

    @Override
    public TriangleWalk walk(double[] x, double[] y) {
        Corners corners = Corners.distinct(x, y, MOST_CORNERS);
        int way = corners.turn(0, 1, 2);
        for (int i = 1; i + 1 < corners.size(); i++) {
            requireTurn(corners, 0, i, i + 1, way);
            requireTurn(corners, 0, 1, i + 1, way);
        }
        for (int i = 0; i < corners.size(); i++)
            if (corners.turn(corners.before(i), i, corners.after(i)) == -way)
                throw refusal(corners, i);
        return new Walk(corners, way > 0);
    }

    @Override
    public String choice() {
        return "corner 0, i and i + 1 for i = 1, 2, …";
    }

    private static void requireTurn(Corners corners, int i, int j, int k, int way) {
        if (way == 0 || corners.turn(i, j, k) != way) throw refusal(corners, k);
    }

    private static IllegalArgumentException refusal(Corners corners, int i) {
        return new IllegalArgumentException(
                "a fan needs a convex polygon without corners on the sides at corner 0, but corner "
                        + corners.number[i]
                        + " ("
                        + corners.x[i]
                        + ", "
                        + corners.y[i]
                        + ") is in the way");
    }

    private static final class Walk implements TriangleWalk {
        private final Corners corners;
        private final boolean counterClockwise;
        private int i;

        Walk(Corners corners, boolean counterClockwise) {
            this.corners = corners;
            this.counterClockwise = counterClockwise;
        }

        @Override
        public boolean advance() {
            if (i + 2 == corners.size()) return false;
            i++;
            return true;
        }

        @Override
        public int a() {
            return corners.number[0];
        }

        @Override
        public int b() {
            return corners.number[counterClockwise ? i : i + 1];
        }

        @Override
        public int c() {
            return corners.number[counterClockwise ? i + 1 : i];
        }
    }
}
