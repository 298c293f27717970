package rasterlab.engine.transform;

import org.joml.Vector3d;

/** Unit vectors of any finite vector, however long or short: nothing overflows on the way. */
public final class Directions {
    /**
     * The sine of the angle below which two directions count as parallel: a cross product of unit
     * vectors errs by some 10⁻¹⁶, so above 10⁻⁸ half of its digits are right.
     */
    public static final double PARALLEL = 1e-8;

    private Directions() {}

    /**
     * @param v finite and not zero
     */
    public static Vector3d unit(Vector3d v) {
        double largest = Math.max(Math.abs(v.x), Math.max(Math.abs(v.y), Math.abs(v.z)));
        var safe = new Vector3d(v.x / largest, v.y / largest, v.z / largest);
        double length = Math.sqrt(safe.x * safe.x + safe.y * safe.y + safe.z * safe.z);
        return new Vector3d(safe.x / length, safe.y / length, safe.z / length);
    }

    /** The unit vector from one point to another. */
    static Vector3d between(Vector3d from, Vector3d to) {
        return unit(
                new Vector3d(to.x / 2 - from.x / 2, to.y / 2 - from.y / 2, to.z / 2 - from.z / 2));
    }
}
