package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * An ellipse by its angle: u = a·sin t, v = b·cos t, rounded, t from 0 to π/2 in steps of 1/max(a,
 * b).
 *
 * <p>No step is longer than one pixel, so there is no gap, but rounding both coordinates of a point
 * that is not above a column's middle may light the pixel beside the nearest one, and a column may
 * get two. Pixels that come twice in a row are sent once.
 *
 * <p>Source: the ellipse's parametric equation.
 */
public final class ParametricEllipse implements SteppedEllipse {
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
        return "t, the angle from the upper end of the axis; the next one is t + 1/max(a, b)";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(new Work(0, 2, 1, 2, 0), 2, Work.NONE, Work.NONE);
    }

    private static final class Walk extends CountedArc {
        private final int radiusX;
        private final int radiusY;
        private final int longer;
        private final long steps;
        private long i;
        private double t;
        private int u = -1;
        private int v = -1;

        Walk(int radiusX, int radiusY) {
            MidpointEllipse.check("x", radiusX);
            MidpointEllipse.check("y", radiusY);
            this.radiusX = radiusX;
            this.radiusY = radiusY;
            longer = Math.max(radiusX, radiusY);
            steps = (long) Math.ceil(Math.PI / 2 * longer);
        }

        @Override
        public boolean advance() {
            int lastU = u;
            int lastV = v;
            do {
                if (i > steps) return false;
                choices++;
                t = longer == 0 ? 0 : Math.min((double) i / longer, Math.PI / 2);
                u = (int) Math.rint(radiusX * Math.sin(t));
                v = (int) Math.rint(radiusY * Math.cos(t));
                i++;
            } while (u == lastU && v == lastV);
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
