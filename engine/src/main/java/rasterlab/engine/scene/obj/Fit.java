package rasterlab.engine.scene.obj;

/**
 * Moves the middle of a model's bounding box to the origin and scales it so that its farthest
 * vertex is {@value #RADIUS} world units away, or up to a thousandth less: the factor has ten
 * binary digits, so that scaling rounds nothing of coordinates that have at most 43.
 */
final class Fit {
    static final double RADIUS = 100;

    private static final int DIGITS = 10;

    private final double[] xyz;
    private final double[] middle = new double[3];
    private final int exponent;
    private final double scale;

    /**
     * @param xyz coordinates of vertices
     * @param used the numbers of those that something is drawn at; others stay where no one looks
     */
    Fit(double[] xyz, int[] used) {
        this.xyz = xyz;
        for (int axis = 0; axis < 3; axis++) middle[axis] = middle(used, axis);
        double farthest = 0;
        for (int v : used)
            farthest = Math.max(farthest, Math.hypot(Math.hypot(off(v, 0), off(v, 1)), off(v, 2)));
        exponent = TinyLengths.exponent(farthest);
        scale = farthest == 0 ? 1 : rounded(RADIUS / Math.scalb(farthest, exponent));
    }

    private static double rounded(double scale) {
        double unit = Math.scalb(1.0, Math.getExponent(scale) - DIGITS + 1);
        return Math.floor(scale / unit) * unit;
    }

    private double middle(int[] used, int axis) {
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int v : used) {
            low = Math.min(low, xyz[3 * v + axis]);
            high = Math.max(high, xyz[3 * v + axis]);
        }
        return low / 2 + high / 2;
    }

    private double off(int vertex, int axis) {
        return xyz[3 * vertex + axis] - middle[axis];
    }

    /** The fitted coordinates of all vertices; 0 of those that are not used. */
    double[] fitted(int[] used) {
        double[] fitted = new double[xyz.length];
        for (int v : used)
            for (int axis = 0; axis < 3; axis++)
                fitted[3 * v + axis] = scale * Math.scalb(off(v, axis), exponent);
        return fitted;
    }
}
