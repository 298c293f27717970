package rasterlab.engine.light;

/**
 * Points with the light that falls on them, one array for each number; cells [0, count) are used.
 */
final class IncidentLight {
    static final int SIZE = 128;

    int count;

    final double[] x = new double[SIZE];
    final double[] y = new double[SIZE];
    final double[] z = new double[SIZE];

    /** Normals of length 1, or 0 where there is none. */
    final double[] nx = new double[SIZE];

    final double[] ny = new double[SIZE];
    final double[] nz = new double[SIZE];

    /** Directions to the eye, of length 1. */
    final double[] vx = new double[SIZE];

    final double[] vy = new double[SIZE];
    final double[] vz = new double[SIZE];

    /** The factors of one light's ambient, diffuse and specular shares. */
    final double[] ambient = new double[SIZE];

    final double[] diffuse = new double[SIZE];
    final double[] specular = new double[SIZE];

    /** The cosines that the specular term raises to a power, and their powers of two. */
    final double[] mirrored = new double[SIZE];

    private final double[] square = new double[SIZE];

    /** Multiplies the specular factors by {@link Powers#of} the mirrored cosines. */
    void raise(double exponent) {
        int whole = (int) exponent;
        if (whole != exponent) {
            for (int i = 0; i < count; i++) specular[i] *= Powers.of(mirrored[i], exponent);
            return;
        }
        System.arraycopy(mirrored, 0, square, 0, count);
        for (int i = 0; i < count; i++) mirrored[i] = 1;
        for (; whole > 0; whole >>= 1) {
            if ((whole & 1) != 0) for (int i = 0; i < count; i++) mirrored[i] *= square[i];
            for (int i = 0; i < count; i++) square[i] *= square[i];
        }
        for (int i = 0; i < count; i++) specular[i] *= mirrored[i];
    }
}
