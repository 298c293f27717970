package rasterlab.engine.visibility.buffer;

import rasterlab.engine.visibility.NearestSeen;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The nearnesses that a depth buffer stores: ρ/z in perspective, −z in parallel projection.
 *
 * @param nearest that of the near plane
 * @param farthest that of the far plane, not above {@code nearest}
 */
public record NearnessRange(double nearest, double farthest) {
    public NearnessRange {
        if (!(farthest <= nearest && nearest - farthest < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "range needs finite nearnesses, farthest not above nearest, got %s to %s"
                            .formatted(farthest, nearest));
    }

    /**
     * The view's own planes where both are finite, else the depths that the mesh has in them; of a
     * mesh that reaches past the near plane only what the picture shows counts.
     */
    public static NearnessRange of(ViewedMesh view) {
        double near = view.near();
        double far = view.far();
        if (Double.isInfinite(near) || Double.isInfinite(far)) {
            double least = far;
            double most = near;
            for (int v = 0; v < view.mesh().vertexCount(); v++) {
                least = Math.min(least, view.eyeZ(v));
                most = Math.max(most, view.eyeZ(v));
            }
            if (view.transform().central() && least < near) least = NearestSeen.of(view);
            near = Math.max(near, least);
            far = Math.min(far, most);
        }
        // Nothing lies between the planes, so any range will do.
        if (!(near <= far) || Double.isInfinite(near) || Double.isInfinite(far))
            return new NearnessRange(0, 0);
        if (!view.transform().central()) return new NearnessRange(-near, -far);
        double distance = view.transform().distance();
        return new NearnessRange(distance / near, distance / far);
    }

    /** The factor by which nearness runs from 0 to 1; 0 where all depths are equal. */
    double scale() {
        double extent = nearest - farthest;
        double scale = 1 / extent;
        return Double.isInfinite(scale) ? 0 : scale;
    }
}
