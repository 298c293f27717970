package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * A circle by the choice among three pixels: to the side, diagonally, down.
 *
 * <p>From (0, r) to (r, 0) a quadrant is walked. F(u, v) = u² + v² − r² tells how far a pixel is
 * from the circle, in squares. Δ = F(u + 1, v − 1) of the diagonal pixel D says which two compete:
 * where D is inside (Δ &lt; 0), the circle passes between D and the pixel to the side H, and H is
 * nearer when |F(H)| &lt; |F(D)|, that is F(H) + F(D) = 2·Δ + 2·v − 1 &lt; 0; where D is outside,
 * between D and the pixel below V, and V is nearer when F(D) + F(V) = 2·Δ − 2·u − 1 &gt; 0. For a
 * whole radius the nearer by squares is also the nearer by distance.
 *
 * <p>A step aside adds 2·u + 1 of the new u to Δ, a step down takes 2·v − 1 of the new v off; both
 * numbers are kept and change by 2, so nothing is multiplied.
 *
 * <p>|2·Δ| + 2·r + 1 &lt; 2³⁶ for int radii, so a long never overflows.
 *
 * <p>Source: J. E. Bresenham, A linear algorithm for incremental digital display of circular arcs,
 * Communications of the ACM 20(2), 1977, pp. 100–106.
 */
public final class BresenhamCircle implements SteppedCircle {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {
        var mirror = Mirror.about(centerX, centerY, radius, radius, out);
        var walk = new Walk(radius);
        while (walk.advance()) mirror.four(walk.u, walk.v);
    }

    @Override
    public ArcWalk walk(int radius) {
        return new Walk(radius);
    }

    @Override
    public String decisionFormula() {
        return "Δ = (u + 1)² + (v − 1)² − r²; Δ < 0: side or diagonal, Δ > 0: diagonal or down";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(
                new Work(2, 0, 0, 0, 2), 0, new Work(2, 0, 0, 0, 0), new Work(2, 0, 0, 0, 0));
    }

    private static final class Walk implements ArcWalk {
        private int u;
        private int v;
        private long delta;
        private long asideStep;
        private long downStep;
        private boolean begun;

        Walk(int radius) {
            v = radius;
            delta = 2 - 2L * radius;
            asideStep = 1;
            downStep = 2L * radius - 1;
        }

        @Override
        public boolean advance() {
            if (!begun) {
                begun = true;
                return true;
            }
            if (v == 0) return false;
            boolean inside = delta < 0;
            long twice = delta + delta;
            if (inside || twice - asideStep <= 0) {
                u++;
                asideStep += 2;
                delta += asideStep;
            }
            if (!inside || twice + downStep >= 0) {
                v--;
                downStep -= 2;
                delta -= downStep;
            }
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
            return delta;
        }
    }
}
