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

    /**
     * The cross product of the unit vectors from one point to another and of {@code along}, each
     * coordinate right to some 10⁻¹⁶ of its length however small the angle between them: the
     * difference of the points and the products keep what their rounding loses.
     *
     * @param along finite and not zero
     */
    static Vector3d across(Vector3d from, Vector3d to, Vector3d along) {
        double[] high = new double[3];
        double[] low = new double[3];
        boolean far = !new Vector3d(to).sub(from).isFinite();
        double part = far ? 0.25 : 1;
        for (int i = 0; i < 3; i++) {
            double a = to.get(i) * part;
            double b = from.get(i) * part;
            high[i] = a - b;
            double back = high[i] - a;
            low[i] = (a - (high[i] - back)) - (b + back);
        }
        double[] other = {along.x, along.y, along.z};
        int size = -exponent(high);
        scale(high, size);
        scale(low, size);
        scale(other, -exponent(other));
        double lengths = length(high) * length(other);
        return new Vector3d(
                        cross(high, low, other, 1, 2),
                        cross(high, low, other, 2, 0),
                        cross(high, low, other, 0, 1))
                .div(lengths);
    }

    private static double cross(double[] high, double[] low, double[] other, int i, int j) {
        double rest = low[i] * other[j] - low[j] * other[i];
        return difference(high[i], other[j], high[j], other[i]) + rest;
    }

    /** a·b − c·d, off by at most 1.5 units of its last place (Jeannerod, Louvet, Muller, 2013). */
    private static double difference(double a, double b, double c, double d) {
        double product = c * d;
        double lost = Math.fma(-c, d, product);
        return Math.fma(a, b, -product) + lost;
    }

    private static int exponent(double[] v) {
        return Math.getExponent(Math.max(Math.abs(v[0]), Math.max(Math.abs(v[1]), Math.abs(v[2]))));
    }

    private static void scale(double[] v, int exponent) {
        for (int i = 0; i < 3; i++) v[i] = Math.scalb(v[i], exponent);
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    /** The unit vector from one point to another. */
    static Vector3d between(Vector3d from, Vector3d to) {
        return unit(
                new Vector3d(to.x / 2 - from.x / 2, to.y / 2 - from.y / 2, to.z / 2 - from.z / 2));
    }
}
