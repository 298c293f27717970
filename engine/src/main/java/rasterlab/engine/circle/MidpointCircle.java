package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * A circle by the side on which the middle between two candidates lies.
 *
 * <p>From (0, r) the octant 0 ≤ u ≤ v is walked column by column. The next pixel is (u + 1, v) or
 * (u + 1, v − 1), and the middle between them is M = (u + 1, v − ½). F(u, v) = u² + v² − r² is
 * negative inside: where F(M) &lt; 0 the circle passes above M. F(M) = (u + 1)² + v² − v + ¼ − r²
 * is never 0, and the ¼ never changes its sign, so d = F(M) − ¼ decides: d &lt; 0 keeps the row. A
 * step aside adds 2·u + 1 (the new u), a step down takes 2·v (the new v) off; both numbers are kept
 * and change by 2, so nothing is multiplied.
 *
 * <p>The first call of {@code advance} goes from u = −1 to the first pixel (0, r). The last one may
 * step past the diagonal, which is no pixel of the octant.
 *
 * <p>|d| ≤ 2·r + 1 &lt; 2³² for int radii, so a long never overflows.
 *
 * <p>Source: M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a digital
 * plotter, Computer Journal 10(3), 1967, pp. 282–289.
 */
public final class MidpointCircle implements SteppedCircle {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {
        Mirror.requireRoom(centerX, centerY, radius, radius);
        var walk = new Walk(radius);
        while (walk.advance()) plotEight(centerX, centerY, walk.u, walk.v, out);
    }

    /** Plots a pixel of the octant and its mirror images, of which some coincide, each once. */
    private static void plotEight(int x, int y, int u, int v, Pixels out) {
        plotFour(x, y, u, v, out);
        if (u != v) plotFour(x, y, v, u, out);
    }

    /** Plots a pixel and its images across both axes: four, two on an axis, one in the middle. */
    private static void plotFour(int x, int y, int u, int v, Pixels out) {
        out.plot(x + u, y + v);
        if (u != 0) out.plot(x - u, y + v);
        if (v == 0) return;
        out.plot(x + u, y - v);
        if (u != 0) out.plot(x - u, y - v);
    }

    @Override
    public ArcWalk walk(int radius) {
        return new Walk(radius);
    }

    @Override
    public String decisionFormula() {
        return "d = (u + 1)² + v² − v − r²; v stays when d < 0, else v ← v − 1";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(
                new Work(0, 0, 0, 0, 1), 0, new Work(2, 0, 0, 0, 0), new Work(2, 0, 0, 0, 0));
    }

    private static final class Walk implements ArcWalk {
        private int u = -1;
        private int v;
        private long d;
        private long asideStep = -1;
        private long downStep;

        Walk(int radius) {
            v = radius;
            d = -radius;
            downStep = 2L * radius;
        }

        @Override
        public boolean advance() {
            if (u >= v) return false;
            boolean hasPixel = u >= 0; // not before the first call
            if (hasPixel && d >= 0) { // M is outside: the row below is nearer
                v--;
                downStep -= 2;
                d -= downStep;
            }
            u++;
            if (u > v) return false;
            asideStep += 2;
            d += asideStep;
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
