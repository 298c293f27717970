package rasterlab.engine.visibility;

/**
 * A convex polygon in eye space that is cut at planes of constant z, through the eye, or any.
 *
 * <p>A new corner is computed from the kept end of its edge to the lost one, so two polygons that
 * share an edge get bit-equal ones.
 */
final class EyePolygon {
    final double[] x;
    final double[] y;
    final double[] z;
    int size;

    /** How far each corner is on the side that a cut keeps, in units of the plane's own. */
    private final double[] inside;

    /**
     * @param mostCorners the most corners there will be; each cut may add one
     */
    EyePolygon(int mostCorners) {
        x = new double[mostCorners];
        y = new double[mostCorners];
        z = new double[mostCorners];
        inside = new double[mostCorners];
    }

    void add(double eyeX, double eyeY, double eyeZ) {
        x[size] = eyeX;
        y[size] = eyeY;
        z[size] = eyeZ;
        size++;
    }

    /**
     * Finds the part of this polygon with {@code side·z ≥ side·plane}.
     *
     * @param side 1 keeps what is farther than the plane, −1 what is nearer
     * @param kept receives it
     */
    void cut(double plane, int side, EyePolygon kept) {
        kept.size = 0;
        for (int a = size - 1, b = 0; b < size; a = b++) {
            boolean aIn = side * z[a] >= side * plane;
            boolean bIn = side * z[b] >= side * plane;
            if (aIn != bIn) kept.addCrossing(this, aIn ? a : b, aIn ? b : a, plane);
            if (bIn) kept.add(x[b], y[b], z[b]);
        }
    }

    /**
     * Finds the part of this polygon on the positive side of a plane through the eye, n·p ≥ 0.
     *
     * @param normal x, y, z of n
     * @param kept receives it
     */
    void cut(double[] normal, EyePolygon kept) {
        for (int i = 0; i < size; i++)
            inside[i] = normal[0] * x[i] + normal[1] * y[i] + normal[2] * z[i];
        cutInside(kept);
    }

    /**
     * Finds the part of this polygon on the drawn side of a view's clip plane.
     *
     * @param plane its number
     * @param kept receives it
     */
    void cut(ViewedMesh view, int plane, EyePolygon kept) {
        for (int i = 0; i < size; i++) inside[i] = view.clipDistance(plane, x[i], y[i], z[i]);
        cutInside(kept);
    }

    private void cutInside(EyePolygon kept) {
        kept.size = 0;
        for (int a = size - 1, b = 0; b < size; a = b++) {
            boolean aIn = inside[a] >= 0;
            boolean bIn = inside[b] >= 0;
            if (aIn != bIn) kept.addCrossing(this, aIn ? a : b, aIn ? b : a);
            if (bIn) kept.add(x[b], y[b], z[b]);
        }
    }

    private void addCrossing(EyePolygon of, int in, int out) {
        double t = of.inside[in] / (of.inside[in] - of.inside[out]);
        add(between(of.x, in, out, t), between(of.y, in, out, t), between(of.z, in, out, t));
    }

    private static double between(double[] values, int a, int b, double t) {
        return values[a] + t * (values[b] - values[a]);
    }

    private void addCrossing(EyePolygon of, int in, int out, double plane) {
        double t = (of.z[in] - plane) / (of.z[in] - of.z[out]);
        add(between(of.x, in, out, t), between(of.y, in, out, t), plane);
    }
}
