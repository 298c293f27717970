package rasterlab.engine.circle;

import rasterlab.contract.Pixels;

/**
 * An ellipse by the choice among three pixels: to the side, diagonally, down.
 *
 * <p>F(u, v) = 4·(b²·u² + a²·v² − a²·b²) is negative inside. The pixel to the side is next where
 * row v or column u + 1 has its nearest pixel there: F(u + ½, v) &lt; 0 or F(u + 1, v − ½) &lt; 0.
 * The pixel below is next where column u or row v − 1 has its nearest pixel there: F(u, v − ½) ≥ 0
 * or F(u + ½, v − 1) ≥ 0. Both cannot be, since F grows with u and v; where neither is, it is the
 * diagonal one. Comparing |F| of the pixels themselves, as for a circle, would err: for an ellipse
 * the nearer by F is not always the nearer by distance.
 *
 * <p>Near the curve |F| &lt; 16·(a²·b + a·b²) ≤ 2⁶² for half-axes up to {@value
 * MidpointEllipse#LARGEST}, so a long never overflows.
 *
 * <p>Source: after J. E. Bresenham, A linear algorithm for incremental digital display of circular
 * arcs, Communications of the ACM 20(2), 1977, pp. 100–106.
 */
public final class BresenhamEllipse implements SteppedEllipse {
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
        return "F(u, v) = 4·(b²·u² + a²·v² − a²·b²): below 0 inside, above 0 outside";
    }

    private static final class Walk implements ArcWalk {
        private final long aa;
        private final long bb;
        private final int a;
        private int u = -1;
        private int v;
        private long f;

        Walk(int a, int b) {
            MidpointEllipse.check("x", a);
            MidpointEllipse.check("y", b);
            this.a = a;
            aa = (long) a * a;
            bb = (long) b * b;
            v = b;
        }

        @Override
        public boolean advance() {
            if (u < 0) u = 0;
            else if (v > 0) choose();
            else if (u < a) u++;
            else return false;
            return true;
        }

        private void choose() {
            long halfAside = bb * (4L * u + 1);
            long halfDown = -aa * (4L * v - 1);
            long aside = 4 * bb * (2L * u + 1);
            long down = -4 * aa * (2L * v - 1);
            if (f + halfAside < 0 || f + aside + halfDown < 0) {
                u++;
                f += aside;
            } else if (f + halfDown >= 0 || f + halfAside + down >= 0) {
                v--;
                f += down;
            } else {
                u++;
                v--;
                f += aside + down;
            }
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
            return f;
        }
    }
}
