package rasterlab.engine.border;

import java.math.BigDecimal;
import java.util.function.DoubleUnaryOperator;
import rasterlab.engine.geometry.Vector;

/** The range of topic {@code depth-order}, measured in a way of its own, with a little room. */
final class OrderRange {
    private static final double LEAST = 1.01e-6;

    /** How often a third is left out: what is left is 10⁻⁹ of the beginning. */
    private static final int THIRDS = 51;

    private OrderRange() {}

    /**
     * @throws IllegalArgumentException if a polygon is too narrow, too near to the eye or edge on
     *     by rounding alone
     */
    static void require(double[][] polygons, double[] eye) {
        double largest = 0;
        for (double value : eye) largest = Math.max(largest, Math.abs(value));
        for (double[] xyz : polygons)
            for (double value : xyz) largest = Math.max(largest, Math.abs(value));
        for (double[] xyz : polygons)
            for (int i = 2; i < xyz.length / 3; i++) {
                require(corner(xyz, 0, eye), corner(xyz, i - 1, eye), corner(xyz, i, eye), largest);
                requireClearlyEdgeOn(xyz, i, eye, largest);
            }
    }

    /** A plane holds the eye exactly, or misses it by more than the contract takes for nothing. */
    private static void requireClearlyEdgeOn(double[] xyz, int i, double[] eye, double largest) {
        Vector a = corner(xyz, 0, eye);
        Vector b = corner(xyz, i - 1, eye);
        Vector c = corner(xyz, i, eye);
        Vector normal = b.minus(a).cross(c.minus(a));
        if (Math.abs(normal.dot(a)) > 1.01e-12 * largest * normal.length()) return;
        if (determinant(exact(xyz, 0, eye), exact(xyz, i - 1, eye), exact(xyz, i, eye)).signum()
                != 0) throw new IllegalArgumentException("edge on but for rounding");
    }

    private static BigDecimal determinant(BigDecimal[] a, BigDecimal[] b, BigDecimal[] c) {
        BigDecimal sum = BigDecimal.ZERO;
        for (int axis = 0; axis < 3; axis++) {
            int u = (axis + 1) % 3;
            int v = (axis + 2) % 3;
            BigDecimal cross = b[u].multiply(c[v]).subtract(b[v].multiply(c[u]));
            sum = sum.add(a[axis].multiply(cross));
        }
        return sum;
    }

    private static BigDecimal[] exact(double[] xyz, int i, double[] eye) {
        var corner = new BigDecimal[3];
        for (int axis = 0; axis < 3; axis++)
            corner[axis] = new BigDecimal(xyz[3 * i + axis]).subtract(new BigDecimal(eye[axis]));
        return corner;
    }

    private static Vector corner(double[] xyz, int i, double[] eye) {
        return new Vector(xyz[3 * i] - eye[0], xyz[3 * i + 1] - eye[1], xyz[3 * i + 2] - eye[2]);
    }

    private static void require(Vector a, Vector b, Vector c, double largest) {
        Vector normal = b.minus(a).cross(c.minus(a));
        double longest =
                Math.max(b.minus(a).length(), Math.max(c.minus(a).length(), c.minus(b).length()));
        if (!(longest > 0 && longest >= LEAST * largest)
                || !(normal.length() / 2 >= LEAST * largest * longest)
                || !(normal.length() >= 1e-8 * longest * longest))
            throw new IllegalArgumentException("too narrow");
        // From the plane is a good guess, from the triangle takes far longer.
        if (Math.abs(normal.dot(a)) >= LEAST * largest * normal.length()) return;
        if (!(distance(a, b, c) >= LEAST * largest))
            throw new IllegalArgumentException("too near to the eye");
    }

    /** The distance from the origin: it grows both ways from the nearest point, on every line. */
    private static double distance(Vector a, Vector b, Vector c) {
        return least(
                s -> {
                    Vector from = a.plus(b.minus(a).times(s));
                    Vector to = a.plus(c.minus(a).times(s));
                    return least(t -> from.plus(to.minus(from).times(t)).length());
                });
    }

    private static double least(DoubleUnaryOperator distance) {
        double from = 0;
        double to = 1;
        for (int i = 0; i < THIRDS; i++) {
            double third = (to - from) / 3;
            if (distance.applyAsDouble(from + third) <= distance.applyAsDouble(to - third))
                to -= third;
            else from += third;
        }
        return distance.applyAsDouble((from + to) / 2);
    }
}
