package rasterlab.engine.visibility.ray;

import java.util.Arrays;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.OnePlane;
import rasterlab.engine.visibility.Tally;

/**
 * One ray after the other, each with the faces it meets: the nearest first, up to the first one
 * that is opaque. Of faces met at one depth, or in {@link OnePlane} at depths that rounding may
 * have parted, the earlier one counts as nearer.
 */
final class RayHits {
    private final RayTargets targets;
    private final FacePaint paint;
    private final RaySpan drawn;
    private final Tally tally;
    private final double[] inverse = new double[3];
    private double[] ray;
    private double nearest;
    private double end;
    private double[] depths = new double[8];
    private int[] faces = new int[8];
    private int count;

    /**
     * @param drawn what counts of a ray
     */
    RayHits(RayTargets targets, FacePaint paint, RaySpan drawn, Tally tally) {
        this.targets = targets;
        this.paint = paint;
        this.drawn = drawn;
        this.tally = tally;
    }

    /**
     * Begins with another ray {@code o + t·d}.
     *
     * @param ray o in 0..2, d in 3..5
     */
    void start(double[] ray) {
        this.ray = ray;
        for (int axis = 0; axis < 3; axis++) inverse[axis] = 1 / ray[3 + axis];
        drawn.load(ray);
        nearest = drawn.begin();
        end = drawn.end();
        count = 0;
    }

    /**
     * The t at which the ray enters a box, infinite if it misses it or ends before.
     *
     * @param boxes least x, y, z of the box from {@code at} on, then the largest ones
     */
    double entry(double[] boxes, int at) {
        tally.comparisons++;
        double enter = nearest;
        double leave = end;
        for (int axis = 0; axis < 3; axis++) {
            double one = (boxes[at + axis] - ray[axis]) * inverse[axis];
            double other = (boxes[at + 3 + axis] - ray[axis]) * inverse[axis];
            // NaN, where the ray runs in a side of the box, changes nothing.
            if (one > other) {
                if (other > enter) enter = other;
                if (one < leave) leave = one;
            } else {
                if (one > enter) enter = one;
                if (other < leave) leave = other;
            }
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    /** Whether a face at that depth could still be seen. */
    boolean reaches(double t) {
        return t <= end && t < Double.POSITIVE_INFINITY;
    }

    void tryFace(int face) {
        tally.depthTests++;
        double t = targets.meets(face, ray);
        if (!(t >= nearest && t <= end)) return;
        int at = count;
        while (at > 0 && nearer(t, face, at - 1)) at--;
        if (at > 0 && paint.opaque(faces[at - 1])) return;
        if (paint.opaque(face)) {
            count = at;
            end = Math.min(drawn.end(), t + targets.room(t));
        }
        insert(at, t, face);
    }

    private boolean nearer(double t, int face, int than) {
        double apart = t - depths[than];
        boolean one =
                apart == 0
                        || Math.abs(apart) <= targets.room(t)
                                && targets.onePlane(face, faces[than]);
        return one ? face < faces[than] : apart < 0;
    }

    private void insert(int at, double t, int face) {
        if (count == faces.length) {
            faces = Arrays.copyOf(faces, 2 * count);
            depths = Arrays.copyOf(depths, 2 * count);
        }
        for (int k = count; k > at; k--) {
            faces[k] = faces[k - 1];
            depths[k] = depths[k - 1];
        }
        faces[at] = face;
        depths[at] = t;
        count++;
    }

    /** Whether just these faces are seen along the ray, the nearest first. */
    boolean same(int[] others) {
        return Arrays.equals(faces, 0, count, others, 0, others.length);
    }

    /** The faces seen along the ray, the nearest first. */
    int[] faces() {
        return Arrays.copyOf(faces, count);
    }
}
