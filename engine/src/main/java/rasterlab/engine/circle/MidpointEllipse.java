package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * An ellipse by the side on which the middle between two candidates lies.
 *
 * <p>F(u, v) = 4·(b²·u² + a²·v² − a²·b²) is negative inside. From (0, b) on, columns are walked
 * while the curve is flatter than 45°, up to the one nearest to a²/√(a² + b²): the nearest row
 * sinks while the middle above the next one is outside, F(u, v − ½) ≥ 0. Then rows are walked, from
 * the one nearest to b²/√(a² + b²) down to 0: the nearest column moves on while the middle before
 * the next one is inside, F(u + ½, v) &lt; 0. Where the two meet, a pixel may be nearest in its
 * column and in its row; it is lit once. Beyond, each column's pixel is that of its row, and the
 * reverse.
 *
 * <p>F at the next middle comes from F at this one by adding or taking off a number that is kept
 * and itself grows by 8·a² or 8·b², so nothing is multiplied on the way. Whether a row's pixel was
 * lit with its column is asked of the rows of the last three columns.
 *
 * <p>Near the curve |F| &lt; 16·(a²·b + a·b²) ≤ 2⁶² for half-axes up to {@value #LARGEST}, so a
 * long never overflows.
 *
 * <p>Sources: M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a digital
 * plotter, Computer Journal 10(3), 1967, pp. 282–289; J. R. Van Aken, An efficient ellipse-drawing
 * algorithm, IEEE Computer Graphics and Applications 4(9), 1984, pp. 24–35.
 */
public final class MidpointEllipse implements SteppedEllipse {
    /** The largest half-axis, in pixels. */
    public static final int LARGEST = 1 << 19;

    @Override
    public void draw(int centerX, int centerY, int radiusX, int radiusY, Pixels out) {
        var mirror = Mirror.about(centerX, centerY, radiusX, radiusY, out);
        var walk = new Walk(radiusX, radiusY);
        while (walk.advance()) mirror.four(walk.u, walk.v);
    }

    @Override
    public ArcWalk walk(int radiusX, int radiusY) {
        return new Walk(radiusX, radiusY);
    }

    @Override
    public String decisionFormula() {
        return "F(u, v − ½) along columns: the row sinks while it is ≥ 0; F(u + ½, v) along rows: the"
                + " column moves on while it is < 0";
    }

    /** Refuses a half-axis whose decisions might overflow. */
    static void check(String axis, int radius) {
        if (radius < 0 || radius > LARGEST)
            throw new IllegalArgumentException(
                    "radius along "
                            + axis
                            + " must be from 0 to "
                            + LARGEST
                            + " pixels, got "
                            + radius);
    }

    @Override
    public ArcWork work() {
        return new ArcWork(
                new Work(0, 0, 0, 0, 1), 0, new Work(2, 0, 0, 0, 0), new Work(2, 0, 0, 0, 0));
    }

    private static final class Walk extends CountedArc {
        private final long aa;
        private final long bb;
        private final long asideMore;
        private final long downMore;
        private final int lastColumn;
        private final int firstRow;
        private boolean alongRows;
        private int u = -1;
        private int v;
        private long d;
        private long aside;
        private long down;

        /** Rows of the last three columns, the last one first. */
        private final int[] lastRows = new int[3];

        Walk(int a, int b) {
            check("x", a);
            check("y", b);
            aa = (long) a * a;
            bb = (long) b * b;
            asideMore = 8 * bb;
            downMore = 8 * aa;
            lastColumn = LastColumn.of(a, b);
            firstRow = LastColumn.of(b, a);
            v = b;
            d = at(-2, 2 * v - 1);
            aside = -12 * bb;
            down = downMore * v;
        }

        @Override
        public boolean advance() {
            if (u < lastColumn) {
                nextColumn();
                return true;
            }
            do {
                if (v == 0 && alongRows) return false;
                if (alongRows) nextRow();
                else firstRow();
                moveOn();
            } while (u <= lastColumn && v == lastRows[lastColumn - u]);
            return true;
        }

        private void nextColumn() {
            asides++;
            u++;
            aside += asideMore;
            d += aside;
            while (v > 0 && isOutside()) {
                downs++;
                v--;
                down -= downMore;
                d -= down;
            }
            lastRows[2] = lastRows[1];
            lastRows[1] = lastRows[0];
            lastRows[0] = v;
        }

        private void firstRow() {
            alongRows = true;
            v = firstRow;
            u = Math.max(0, lastColumn - 2);
            d = at(2 * u + 1, 2 * v);
            aside = asideMore * u;
            down = 4 * aa * (2L * v + 1);
        }

        private void nextRow() {
            downs++;
            v--;
            down -= downMore;
            d -= down;
        }

        private void moveOn() {
            while (!isOutside()) {
                asides++;
                u++;
                aside += asideMore;
                d += aside;
            }
        }

        private boolean isOutside() {
            choices++;
            return d >= 0;
        }

        /** F at twice the coordinates; its terms may overflow, their sum does not. */
        private long at(long twiceU, long twiceV) {
            return bb * twiceU * twiceU + aa * twiceV * twiceV - 4 * aa * bb;
        }

        @Override
        public int u() {
            return u;
        }

        @Override
        public int v() {
            return v;
        }

        @Override
        public double decision() {
            return d;
        }
    }
}
