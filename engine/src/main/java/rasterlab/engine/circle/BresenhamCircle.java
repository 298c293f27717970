package rasterlab.engine.circle;

import rasterlab.contract.Pixels;

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
 * <p>|2·Δ| + 2·r + 1 &lt; 2³⁶ for int radii, so a long never overflows.
 *
 * <p>Source: J. E. Bresenham, A linear algorithm for incremental digital display of circular arcs,
 * Communications of the ACM 20(2), 1977, pp. 100–106.
 */
public final class BresenhamCircle implements SteppedCircle {
    @Override
    public void draw(int centreX, int centreY, int radius, Pixels out) {
        var mirror = Mirror.about(centreX, centreY, radius, radius, out);
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

    private static final class Walk implements ArcWalk {
        private int u;
        private int v;
        private long delta;
        private boolean begun;

        Walk(int radius) {
            v = radius;
            delta = 2 - 2L * radius;
        }

        @Override
        public boolean advance() {
            if (!begun) return begun = true;
            if (v == 0) return false;
            boolean aside = delta < 0 || 2 * delta - 2L * u - 1 <= 0;
            boolean down = delta >= 0 || 2 * delta + 2L * v - 1 >= 0;
            if (aside) {
                u++;
                delta += 2L * u + 1;
            }
            if (down) {
                v--;
                delta -= 2L * v - 1;
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
