package rasterlab.engine.pipeline.fast;

/** A polygon between two cuts: corners with clip coordinates and all that they carry. */
final class ClipPolygon {
    /** Clip x, y, z, w, the planes of the user, and the most attributes. */
    private static final int MOST_VALUES = 4 + TriangleView.MOST_PLANES + 12;

    /** The mesh's vertex that a corner is, or {@link #NEW}. */
    final int[] vertex;

    /** The numbers of each corner: x, y, z, w, distances to the user's planes, attributes. */
    final double[][] values;

    int size;
    int planes;
    int attributes;

    static final int NEW = -1;

    ClipPolygon(int mostCorners) {
        vertex = new int[mostCorners];
        values = new double[mostCorners][MOST_VALUES];
    }

    int add(int meshVertex) {
        vertex[size] = meshVertex;
        return size++;
    }

    void addCopy(ClipPolygon from, int corner) {
        int at = add(from.vertex[corner]);
        System.arraycopy(from.values[corner], 0, values[at], 0, MOST_VALUES);
    }

    void addBetween(ClipPolygon from, int inside, int outside, double share) {
        double[] in = from.values[inside];
        double[] out = from.values[outside];
        int at = add(NEW);
        for (int i = 0; i < 4 + planes + attributes; i++)
            values[at][i] = in[i] + share * (out[i] - in[i]);
    }

    /** Attribute k of a corner. */
    double attribute(int corner, int k) {
        return values[corner][4 + planes + k];
    }
}
