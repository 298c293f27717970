package rasterlab.engine.circle;

import rasterlab.contract.Pixels;

/**
 * A circle by the side on which the middle between two candidates lies.
 *
 * <p>From (0, r) the octant 0 ≤ u ≤ v is walked column by column. The next pixel is (u + 1, v) or
 * (u + 1, v − 1), and the middle between them is M = (u + 1, v − ½). F(u, v) = u² + v² − r² is
 * negative inside: where F(M) &lt; 0 the circle passes above M. F(M) = (u + 1)² + v² − v + ¼ − r²
 * is never 0, and the ¼ never changes its sign, so d = F(M) − ¼ decides: d &lt; 0 keeps the row. A
 * step along adds 2·u + 1 (the new u), a step down takes 2·(v − 1) off.
 *
 * <p>|d| ≤ 2·r + 1 &lt; 2³² for int radii, so a long never overflows.
 *
 * <p>Source: M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a digital
 * plotter, Computer Journal 10(3), 1967, pp. 282–289.
 */
public final class MidpointCircle implements SteppedCircle {
    @Override
    public void draw(int centreX, int centreY, int radius, Pixels out) {
        var mirror = Mirror.about(centreX, centreY, radius, radius, out);
        var walk = new Walk(radius);
        while (walk.advance()) mirror.eight(walk.u, walk.v);
    }

    @Override
    public ArcWalk walk(int radius) {
        return new Walk(radius);
    }

    @Override
    public String decisionFormula() {
        return "d = (u + 1)² + v² − v − r²; v stays when d < 0, else v ← v − 1";
    }

    private static final class Walk implements ArcWalk {
        private int u = -1;
        private int v;
        private long d;

        Walk(int radius) {
            v = radius;
            d = -radius;
        }

        @Override
        public boolean advance() {
            if (u >= v) return false;
            if (d >= 0 && u >= 0) {
                d -= 2L * (v - 1);
                v--;
            }
            u++;
            if (u > v) return false;
            d += 2L * u + 1;
            return true;
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
