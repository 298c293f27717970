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

    /**
     * @param mostCorners the most corners there will be; each cut may add one
     */
    EyePolygon(int mostCorners) {
        x = new double[mostCorners];
        y = new double[mostCorners];
        z = new double[mostCorners];
    }

    void add(double eyeX, double eyeY, double eyeZ) {
        x[size] = eyeX;
        y[size] = eyeY;
        z[size] = eyeZ;
        size++;
    }

    /**
     * What of this polygon has {@code side·z ≥ side·plane}.
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
     * What of this polygon is on the positive side of a plane through the eye, n·p ≥ 0.
     *
     * @param normal x, y, z of n
     * @param kept receives it
     */
    void cut(double[] normal, EyePolygon kept) {
        kept.size = 0;
        for (int a = size - 1, b = 0; b < size; a = b++) {
            double atA = normal[0] * x[a] + normal[1] * y[a] + normal[2] * z[a];
            double atB = normal[0] * x[b] + normal[1] * y[b] + normal[2] * z[b];
            if (atA >= 0 != atB >= 0) {
                double t = atA / (atA - atB);
                kept.add(between(x, a, b, t), between(y, a, b, t), between(z, a, b, t));
            }
            if (atB >= 0) kept.add(x[b], y[b], z[b]);
        }
    }

    /**
     * What of this polygon is on the drawn side of a view's clip plane.
     *
     * @param plane its number
     * @param kept receives it
     */
    void cut(ViewedMesh view, int plane, EyePolygon kept) {
        kept.size = 0;
        for (int a = size - 1, b = 0; b < size; a = b++) {
            double atA = view.clipDistance(plane, x[a], y[a], z[a]);
            double atB = view.clipDistance(plane, x[b], y[b], z[b]);
            if (atA >= 0 != atB >= 0) {
                int in = atA >= 0 ? a : b;
                int out = in == a ? b : a;
                double t = Math.max(atA, atB) / Math.abs(atA - atB);
                kept.add(between(x, in, out, t), between(y, in, out, t), between(z, in, out, t));
            }
            if (atB >= 0) kept.add(x[b], y[b], z[b]);
        }
    }

    private static double between(double[] values, int a, int b, double t) {
        return values[a] + t * (values[b] - values[a]);
    }

    private void addCrossing(EyePolygon of, int in, int out, double plane) {
        double t = (of.z[in] - plane) / (of.z[in] - of.z[out]);
        add(of.x[in] + t * (of.x[out] - of.x[in]), of.y[in] + t * (of.y[out] - of.y[in]), plane);
    }
}
