package rasterlab.engine.polygon.triangulation;

/**
 * Joins corner 0 to all others: triangles (0, i, i + 1), or (i + 1, i, 0) of a clockwise polygon.
 *
 * <p>Right where the polygon is convex and no other corner lies on the two sides at corner 0; any
 * other is refused. That is so where, seen exactly, every triangle turns the same way, every corner
 * lies between the directions to the first and the last, and no corner turns the other way.
 */
final class Fan implements SteppedTriangulator {
    private static final int MOST_CORNERS = 10_000_000;

    @Override
    public TriangleWalk walk(double[] x, double[] y) {
        return new Walk(Corners.distinct(x, y, MOST_CORNERS));
    }

    @Override
    public String choice() {
        return "corner 0, i and i + 1 for i = 1, 2, …";
    }

    /** Cuts off corner i, one after another, so that 0 and i + 1 are the ends of the diagonal. */
    private static final class Walk implements TriangleWalk {
        private final Corners corners;
        private final boolean counterClockwise;
        private int i;
        private long turns;

        Walk(Corners corners) {
            this.corners = corners;
            int way = turn(0, 1, 2);
            for (int k = 1; k + 1 < corners.size(); k++) {
                requireTurn(0, k, k + 1, way);
                requireTurn(0, 1, k + 1, way);
            }
            for (int k = 0; k < corners.size(); k++)
                if (turn(corners.before(k), k, corners.after(k)) == -way) throw refusal(k);
            counterClockwise = way > 0;
        }

        private int turn(int i, int j, int k) {
            turns++;
            return corners.turn(i, j, k);
        }

        private void requireTurn(int i, int j, int k, int way) {
            if (way == 0 || turn(i, j, k) != way) throw refusal(k);
        }

        private IllegalArgumentException refusal(int corner) {
            return new IllegalArgumentException(
                    "a fan needs a convex polygon without corners on the sides at corner 0, but"
                            + " corner "
                            + corners.number[corner]
                            + " ("
                            + corners.x[corner]
                            + ", "
                            + corners.y[corner]
                            + ") is in the way");
        }

        @Override
        public boolean advance() {
            if (i + 2 == corners.size()) return false;
            i++;
            return true;
        }

        @Override
        public int a() {
            return corners.number[counterClockwise ? 0 : i + 1];
        }

        @Override
        public int b() {
            return corners.number[i];
        }

        @Override
        public int c() {
            return corners.number[counterClockwise ? i + 1 : 0];
        }

        @Override
        public long turns() {
            return turns;
        }
    }
}
