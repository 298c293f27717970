package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * {@link BresenhamEllipse}'s choice in ints, ended where a textbook ends it: on the first pixel of
 * row 0.
 *
 * <p>A flat ellipse comes to row 0 long before its end, so its tip is lost; of one without height
 * only the centre is left. From half-axes of about 400 on the products do not fit into 32 bits, and
 * the sign of F means nothing.
 *
 * <p>Source: article "Coordinate systems: world, object, observer and screen", section on circles
 * and ellipses, fig. 7, which names the ellipse and leaves both to the reader.
 */
public final class BresenhamTextbookEllipse implements SteppedEllipse {
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
        return "F(u, v) = 4·(b²·u² + a²·v² − a²·b²) in 32 bits: below 0 inside, above 0 outside";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(
                new Work(8, 6, 0, 0, 4), 0, new Work(1, 0, 0, 0, 0), new Work(1, 0, 0, 0, 0));
    }

    private static final class Walk extends CountedArc {
        private final int aa;
        private final int bb;
        private int u = -1;
        private int v;
        private int f;

        Walk(int a, int b) {
            aa = a * a;
            bb = b * b;
            v = b;
        }

        @Override
        public boolean advance() {
            if (u < 0) {
                u = 0;
                return true;
            }
            if (v == 0) return false;
            choose();
            return true;
        }

        private void choose() {
            choices++;
            int halfAside = bb * (4 * u + 1);
            int halfDown = -aa * (4 * v - 1);
            int aside = 4 * bb * (2 * u + 1);
            int down = -4 * aa * (2 * v - 1);
            boolean onlyAside = f + halfAside < 0 | f + aside + halfDown < 0;
            boolean onlyDown = f + halfDown >= 0 | f + halfAside + down >= 0;
            if (!onlyDown || onlyAside) {
                asides++;
                u++;
                f += aside;
            }
            if (!onlyAside) {
                downs++;
                v--;
                f += down;
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
