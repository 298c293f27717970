package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * A circle by its angle: u = r·sin t, v = r·cos t, rounded, t from 0 to π/4 in steps of 1/r.
 *
 * <p>Steps of 1/r move by one pixel along the circle, so no column of the octant is passed over,
 * but rounding both coordinates of a point that is not above a column's middle may light the pixel
 * beside the nearest one, and a column may get two. Pixels that come twice in a row are sent once.
 * Two sines a pixel make it the dearest.
 *
 * <p>Source: the circle's parametric equation.
 */
public final class ParametricCircle implements SteppedCircle {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {
        var mirror = Mirror.about(centerX, centerY, radius, radius, out);
        var walk = new Walk(radius);
        while (walk.advance()) mirror.eight(walk.u, walk.v);
    }

    @Override
    public ArcWalk walk(int radius) {
        return new Walk(radius);
    }

    @Override
    public String decisionFormula() {
        return "t, the angle from the vertical; the next one is t + 1/r";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(new Work(0, 2, 1, 2, 0), 2, Work.NONE, Work.NONE);
    }

    private static final class Walk extends CountedArc {
        private final int radius;
        private final long steps;
        private long i;
        private double t;
        private int u = -1;
        private int v = -1;

        Walk(int radius) {
            this.radius = radius;
            steps = (long) Math.ceil(Math.PI / 4 * radius);
        }

        @Override
        public boolean advance() {
            int lastU = u;
            int lastV = v;
            do {
                if (i > steps) return false;
                choices++;
                t = radius == 0 ? 0 : (double) i / radius;
                u = (int) Math.rint(radius * Math.sin(t));
                v = (int) Math.rint(radius * Math.cos(t));
                i++;
            } while (u > v || u == lastU && v == lastV);
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
            return t;
        }
    }
}
