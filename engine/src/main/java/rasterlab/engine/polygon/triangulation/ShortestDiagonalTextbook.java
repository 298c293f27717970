package rasterlab.engine.polygon.triangulation;

import rasterlab.engine.range.Finite;

/**
 * The course's shortest-diagonal listing, its slips mended, with the faults of its idea.
 *
 * <p>Of the corners i whose turn {@code D = (xi − xh)·(yj − yh) − (xj − xh)·(yi − yh)} exceeds 10⁻⁶
 * the one with the shortest diagonal from h to j is cut, if it is below 10³⁰. Whether another
 * corner lies in the triangle is not asked. So polygons in small units, large ones, and those given
 * clockwise have no such corner; then the corner of the last cut's place is cut, whatever it is.
 *
 * <p>Two slips of the listing as printed are mended, since with them it cuts nothing at all ({@link
 * ShortestDiagonalPrintedTextbook} has them): it assigns i + 1 to h where j is meant, and closes
 * the gap in the list of corners from the first corner on instead of from i.
 */
final class ShortestDiagonalTextbook implements SteppedTriangulator {
    private static final double BIG = 1e30;
    private static final double LEAST_TURN = 0.000001;

    @Override
    public TriangleWalk walk(double[] x, double[] y) {
        Finite.requirePoints("corner", x, y, 3);
        Corners.requireAtMost(EarClipping.MOST_CORNERS, x.length);
        return new Walk(x, y);
    }

    @Override
    public String choice() {
        return "D > 10⁻⁶ with the least (xj − xh)² + (yj − yh)²";
    }

    private static final class Walk implements TriangleWalk {
        private final double[] x;
        private final double[] y;
        private final int[] v;
        private int m;
        private int chosen;
        private int a;
        private int b;
        private int c;
        private long turns;

        Walk(double[] x, double[] y) {
            this.x = x;
            this.y = y;
            m = x.length;
            v = new int[m];
            for (int i = 0; i < m; i++) v[i] = i;
        }

        @Override
        public boolean advance() {
            if (m < 3) return false;
            double least = BIG;
            for (int i = 0; i < m; i++) {
                double diagonal = diagonal(i);
                if (turn(i) > LEAST_TURN && diagonal < least) {
                    least = diagonal;
                    chosen = i;
                }
            }
            // Nothing was found, and the place of the last cut may be beyond the shorter list.
            if (chosen >= m) chosen = 0;
            a = v[before(chosen)];
            b = v[chosen];
            c = v[after(chosen)];
            m--;
            System.arraycopy(v, chosen + 1, v, chosen, m - chosen);
            return true;
        }

        private int before(int i) {
            return i == 0 ? m - 1 : i - 1;
        }

        private int after(int i) {
            return i == m - 1 ? 0 : i + 1;
        }

        private double diagonal(int i) {
            double dx = x[v[after(i)]] - x[v[before(i)]];
            double dy = y[v[after(i)]] - y[v[before(i)]];
            return dx * dx + dy * dy;
        }

        private double turn(int i) {
            turns++;
            int h = v[before(i)];
            double dxi = x[v[i]] - x[h];
            double dyi = y[v[i]] - y[h];
            double dxj = x[v[after(i)]] - x[h];
            double dyj = y[v[after(i)]] - y[h];
            return dxi * dyj - dxj * dyi;
        }

        @Override
        public int a() {
            return a;
        }

        @Override
        public int b() {
            return b;
        }

        @Override
        public int c() {
            return c;
        }

        @Override
        public long turns() {
            return turns;
        }
    }
}
