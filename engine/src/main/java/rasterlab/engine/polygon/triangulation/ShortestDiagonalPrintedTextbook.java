package rasterlab.engine.polygon.triangulation;

import rasterlab.engine.range.Finite;

/**
 * The course's shortest-diagonal listing as printed, counting from 1 as it does.
 *
 * <p>Erratum: where the corner after i is meant for j, both places assign it to h. So j keeps the 0
 * it was declared with, and the first turn asks for the corner number V(0), which there is none of.
 * {@link ShortestDiagonalTextbook} has this mended, and with it the slip behind it: the list of
 * corners loses its first one at each cut, whichever was cut.
 */
final class ShortestDiagonalPrintedTextbook implements SteppedTriangulator {
    private static final double BIG = 1e30;
    private static final double LEAST_TURN = 0.000001;

    @Override
    public TriangleWalk walk(double[] x, double[] y) {
        Finite.requirePoints("corner", x, y, 3);
        return new Walk(x, y);
    }

    @Override
    public String choice() {
        return "D > 10⁻⁶ with the least (xj − xh)² + (yj − yh)², j being unset";
    }

    private static final class Walk implements TriangleWalk {
        private final double[] x;
        private final double[] y;

        /** V(1) … V(m), numbers of corners from 1; V(0) is not used. */
        private final int[] v;

        private int m;
        private int h;
        private int i;
        private int j;
        private int least;
        private long turns;

        Walk(double[] x, double[] y) {
            this.x = x;
            this.y = y;
            m = x.length;
            v = new int[m + 1];
            for (int k = 1; k <= m; k++) v[k] = k;
        }

        @Override
        public boolean advance() {
            if (m <= 2) return false;
            double leastDiagonal = BIG;
            for (i = 1; i <= m; i++) {
                setNeighbours();
                if (turn() > LEAST_TURN && diagonal() < leastDiagonal) {
                    leastDiagonal = diagonal();
                    least = i;
                }
            }
            i = least;
            setNeighbours();
            m--;
            for (int l = 1; l <= m; l++) v[l] = v[l + 1];
            return true;
        }

        private void setNeighbours() {
            if (i == 1) h = m;
            else h = i - 1;
            if (i == m) h = 1;
            else h = i + 1;
        }

        private double x(int place) {
            return x[v[place] - 1];
        }

        private double y(int place) {
            return y[v[place] - 1];
        }

        private double diagonal() {
            return (x(j) - x(h)) * (x(j) - x(h)) + (y(j) - y(h)) * (y(j) - y(h));
        }

        private double turn() {
            turns++;
            return (x(i) - x(h)) * (y(j) - y(h)) - (x(j) - x(h)) * (y(i) - y(h));
        }

        @Override
        public int a() {
            return v[h] - 1;
        }

        @Override
        public int b() {
            return v[i] - 1;
        }

        @Override
        public int c() {
            return v[j] - 1;
        }

        @Override
        public long turns() {
            return turns;
        }
    }
}
