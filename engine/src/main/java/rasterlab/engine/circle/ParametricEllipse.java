package rasterlab.engine.circle;

import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

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
public final class ParametricEllipse implements EllipseRasterizer {
    @Override
    public void draw(int centreX, int centreY, int radiusX, int radiusY, Pixels out) {
        MidpointEllipse.check("x", radiusX);
        MidpointEllipse.check("y", radiusY);
        var mirror = Mirror.about(centreX, centreY, radiusX, radiusY, out);
        int longer = Math.max(radiusX, radiusY);
        long steps = (long) Math.ceil(Math.PI / 2 * longer);
        int lastU = -1;
        int lastV = -1;
        for (long i = 0; i <= steps; i++) {
            double t = longer == 0 ? 0 : Math.min((double) i / longer, Math.PI / 2);
            int u = (int) Math.rint(radiusX * Math.sin(t));
            int v = (int) Math.rint(radiusY * Math.cos(t));
            if (u == lastU && v == lastV) continue;
            mirror.four(u, v);
            lastU = u;
            lastV = v;
        }
    }
}
