package rasterlab.engine.circle;

import rasterlab.contract.Pixels;

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
 * <p>Near the curve |F| &lt; 16·(a²·b + a·b²) ≤ 2⁶² for half-axes up to {@value #LARGEST}, so a
 * long never overflows.
 *
 * <p>Sources: M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a digital
 * plotter, Computer Journal 10(3), 1967; J. R. Van Aken, An efficient ellipse-drawing algorithm,
 * IEEE Computer Graphics and Applications 4(9), 1984.
 */
public final class MidpointEllipse implements SteppedEllipse {
    /** The largest half-axis, in pixels. */
    public static final int LARGEST = 1 << 19;

    @Override
    public void draw(int centreX, int centreY, int radiusX, int radiusY, Pixels out) {
        var mirror = Mirror.about(centreX, centreY, radiusX, radiusY, out);
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
                            + " must be in 0.."
                            + LARGEST
                            + " pixels, got "
                            + radius);
    }

    private static final class Walk implements ArcWalk {
        private final long aa;
        private final long bb;
        private final int lastColumn;
        private final int firstRow;
        private boolean alongRows;
        private int u = -1;
        private int v;
        private long d;

        Walk(int a, int b) {
            check("x", a);
            check("y", b);
            aa = (long) a * a;
            bb = (long) b * b;
            lastColumn = LastColumn.of(a, b);
            firstRow = LastColumn.of(b, a);
            v = b;
            d = atMiddle(-2, 2 * v - 1);
        }

        @Override
        public boolean advance() {
            if (u < lastColumn) {
                nextColumn();
                return true;
            }
            do {
                if (v == 0 && alongRows) return false;
                nextRow();
            } while (u <= lastColumn && isNearestInColumn());
            return true;
        }

        private void nextColumn() {
            u++;
            d += 4 * bb * (2L * u - 1);
            while (d >= 0 && v > 0) {
                v--;
                d -= 8 * aa * v;
            }
        }

        private void nextRow() {
            if (alongRows) {
                v--;
                d -= 4 * aa * (2L * v + 1);
            } else {
                alongRows = true;
                v = firstRow;
                u = Math.max(0, lastColumn - 2);
                d = atMiddle(2 * u + 1, 2 * v);
            }
            while (d < 0) {
                u++;
                d += 8 * bb * u;
            }
        }

        private boolean isNearestInColumn() {
            boolean sinks = v > 0 && atMiddle(2 * u, 2 * v - 1) >= 0;
            return !sinks && atMiddle(2 * u, 2 * v + 1) >= 0;
        }

        /** F at twice the coordinates; its terms may overflow, their sum does not. */
        private long atMiddle(long twiceU, long twiceV) {
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
