package rasterlab.engine.circle;

import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;

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
public final class ParametricCircle implements CircleRasterizer {
    @Override
    public void draw(int centreX, int centreY, int radius, Pixels out) {
        var mirror = Mirror.about(centreX, centreY, radius, radius, out);
        long steps = (long) Math.ceil(Math.PI / 4 * radius);
        int lastU = -1;
        int lastV = -1;
        for (long i = 0; i <= steps; i++) {
            double t = radius == 0 ? 0 : (double) i / radius;
            int u = (int) Math.rint(radius * Math.sin(t));
            int v = (int) Math.rint(radius * Math.cos(t));
            if (u > v || u == lastU && v == lastV) continue;
            mirror.eight(u, v);
            lastU = u;
            lastV = v;
        }
    }
}
