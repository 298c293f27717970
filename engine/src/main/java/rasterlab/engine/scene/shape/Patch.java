package rasterlab.engine.scene.shape;

/**
 * A piece of a surface: a point for each u and v, seen from outside u to the right of v.
 *
 * <p>Cells between two u and two v are flat: two of their sides are parallel.
 */
public interface Patch {
    Span u();

    Span v();

    /**
     * Writes position, outward normal of length 1 and texture coordinates.
     *
     * @param u in {@link #u()}
     * @param v in {@link #v()}
     */
    void at(double u, double v, SurfacePoint out);

    /** Whether all u give one point at this v, an end of {@link #v()}. */
    default boolean isPole(double v) {
        return false;
    }

    /**
     * Whether all of it lies in one plane, its texture laid evenly: however few its faces are, they
     * are off at its border alone.
     */
    default boolean isFlat() {
        return false;
    }

    /** How many steps of v a mesh makes where {@code asked} are asked for. */
    default int vSteps(int asked) {
        return asked;
    }
}
