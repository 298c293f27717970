package rasterlab.engine.visibility;

/**
 * A convex polygon in view space that is cut at planes of constant z.
 *
 * <p>A new corner is computed from the kept end of its edge to the lost one, so two polygons that
 * share an edge get bit-equal ones.
 */
final class ViewPolygon {
    final double[] x;
    final double[] y;
    final double[] z;
    int size;

    /**
     * @param mostCorners the most corners there will be; each cut may add one
     */
    ViewPolygon(int mostCorners) {
        x = new double[mostCorners];
        y = new double[mostCorners];
        z = new double[mostCorners];
    }

    void add(double viewX, double viewY, double viewZ) {
        x[size] = viewX;
        y[size] = viewY;
        z[size] = viewZ;
        size++;
    }

    /**
     * What of this polygon has {@code side·z ≥ side·plane}.
     *
     * @param side 1 keeps what is farther than the plane, −1 what is nearer
     * @param kept receives it
     */
    void cut(double plane, int side, ViewPolygon kept) {
        kept.size = 0;
        for (int a = size - 1, b = 0; b < size; a = b++) {
            boolean aIn = side * z[a] >= side * plane;
            boolean bIn = side * z[b] >= side * plane;
            if (aIn != bIn) kept.addCrossing(this, aIn ? a : b, aIn ? b : a, plane);
            if (bIn) kept.add(x[b], y[b], z[b]);
        }
    }

    private void addCrossing(ViewPolygon of, int in, int out, double plane) {
        double t = (of.z[in] - plane) / (of.z[in] - of.z[out]);
        add(of.x[in] + t * (of.x[out] - of.x[in]), of.y[in] + t * (of.y[out] - of.y[in]), plane);
    }
}
