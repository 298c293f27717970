package rasterlab.engine.visibility.ray;

import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The drawn part of a ray {@code o + t·d} in the world, whose t is depth in eye space: from the
 * near plane to the far one, and on the drawn side of each clip plane.
 */
public final class RaySpan {
    private final ViewedMesh view;
    private double begin;
    private double end;

    public RaySpan(ViewedMesh view) {
        this.view = view;
    }

    /**
     * Takes a ray.
     *
     * @param ray o in 0..2, d in 3..5
     */
    public void load(double[] ray) {
        begin = view.near();
        end = view.far();
        for (ClipPlane plane : view.clipPlanes()) {
            double start = plane.at(ray[0], ray[1], ray[2]);
            double speed = plane.a() * ray[3] + plane.b() * ray[4] + plane.c() * ray[5];
            if (speed > 0) begin = Math.max(begin, -start / speed);
            else if (speed < 0) end = Math.min(end, -start / speed);
            else if (start < 0) end = Double.NEGATIVE_INFINITY;
        }
    }

    /** The smallest t that is drawn. */
    public double begin() {
        return begin;
    }

    /** The largest t that is drawn, below {@link #begin} where nothing is. */
    public double end() {
        return end;
    }
}
