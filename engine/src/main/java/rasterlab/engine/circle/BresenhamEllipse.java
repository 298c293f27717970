package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

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
 * <p>What F changes by is kept: from (u, v) to (u + ½, v) it is b²·(4·u + 1), to (u + 1, v) it is
 * 4·b²·(2·u + 1), and a step aside adds 4·b² and 8·b² to them; the like down. So nothing is
 * multiplied on the way.
 *
 * <p>Near the curve |F| &lt; 16·(a²·b + a·b²) ≤ 2⁶² for half-axes up to {@value
 * MidpointEllipse#LARGEST}, so a long never overflows.
 *
 * <p>Source: after J. E. Bresenham, A linear algorithm for incremental digital display of circular
 * arcs, Communications of the ACM 20(2), 1977, pp. 100–106.
 */
public final class BresenhamEllipse implements SteppedEllipse {
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
        return "F(u, v) = 4·(b²·u² + a²·v² − a²·b²): below 0 inside, above 0 outside";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(
                new Work(4, 0, 0, 0, 4), 0, new Work(4, 0, 0, 0, 0), new Work(4, 0, 0, 0, 0));
    }

    private static final class Walk extends CountedArc {
        private final int a;
        private final long halfAsideMore;
        private final long halfDownMore;
        private int u = -1;
        private int v;
        private long f;
        private long halfAside;
        private long halfDown;
        private long aside;
        private long down;

        Walk(int a, int b) {
            MidpointEllipse.check("x", a);
            MidpointEllipse.check("y", b);
            this.a = a;
            v = b;
            long aa = (long) a * a;
            long bb = (long) b * b;
            halfAside = bb;
            halfAsideMore = 4 * bb;
            aside = 4 * bb;
            halfDown = -aa * (4L * v - 1);
            halfDownMore = 4 * aa;
            down = -4 * aa * (2L * v - 1);
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
            choices++;
            long atHalfAside = f + halfAside;
            long atHalfDown = f + halfDown;
            boolean onlyAside = atHalfAside < 0 | atHalfDown + aside < 0;
            boolean onlyDown = atHalfDown >= 0 | atHalfAside + down >= 0;
            if (!onlyDown || onlyAside) stepAside();
            if (!onlyAside) stepDown();
        }

        private void stepAside() {
            asides++;
            u++;
            f += aside;
            aside += halfAsideMore + halfAsideMore;
            halfAside += halfAsideMore;
        }

        private void stepDown() {
            downs++;
            v--;
            f += down;
            down += halfDownMore + halfDownMore;
            halfDown += halfDownMore;
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
