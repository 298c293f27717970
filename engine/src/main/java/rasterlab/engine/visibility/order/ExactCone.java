package rasterlab.engine.visibility.order;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;

/**
 * All rays from the eye through a convex polygon, as the rays through its corners, in whole
 * numbers: nothing is divided, so nothing is rounded.
 *
 * <p>A ray through p is any positive multiple of p. Where the rays a and b lie on two sides of a
 * plane through the eye, with a·m = s and b·m = −t, the ray t·a + s·b lies in it.
 */
final class ExactCone {
    private final List<BigInteger[]> rays;

    ExactCone(List<BigInteger[]> rays) {
        this.rays = rays;
    }

    /** Whether it has an inside. */
    boolean open() {
        for (int i = 0; i + 2 < rays.size(); i++)
            if (dot(cross(rays.get(0), rays.get(i + 1)), rays.get(i + 2)).signum() != 0)
                return true;
        return false;
    }

    /** The rays common to this and another. */
    ExactCone in(ExactCone other) {
        BigInteger[] inner = new BigInteger[] {BigInteger.ZERO, BigInteger.ZERO, BigInteger.ZERO};
        for (BigInteger[] ray : other.rays)
            for (int axis = 0; axis < 3; axis++) inner[axis] = inner[axis].add(ray[axis]);
        ExactCone left = this;
        for (int i = 0; i < other.rays.size(); i++) {
            BigInteger[] next = other.rays.get((i + 1) % other.rays.size());
            BigInteger[] edge = cross(other.rays.get(i), next);
            int side = dot(edge, inner).signum();
            if (side != 0) left = left.where(side < 0 ? negated(edge) : edge);
        }
        return left;
    }

    /** The rays r with n·r ≥ 0. */
    ExactCone where(BigInteger[] n) {
        var left = new ArrayList<BigInteger[]>();
        for (int i = 0; i < rays.size(); i++) {
            BigInteger[] a = rays.get(i);
            BigInteger[] b = rays.get((i + 1) % rays.size());
            BigInteger s = dot(n, a);
            BigInteger t = dot(n, b).negate();
            if (s.signum() >= 0) left.add(a);
            if (s.signum() * t.signum() > 0) {
                var between = new BigInteger[3];
                for (int axis = 0; axis < 3; axis++)
                    between[axis] = a[axis].multiply(t.abs()).add(b[axis].multiply(s.abs()));
                left.add(reduced(between));
            }
        }
        return new ExactCone(left);
    }

    /** The ray in smaller numbers. */
    private static BigInteger[] reduced(BigInteger[] ray) {
        BigInteger shared = ray[0].gcd(ray[1]).gcd(ray[2]);
        if (shared.signum() == 0) return ray;
        return new BigInteger[] {
            ray[0].divide(shared), ray[1].divide(shared), ray[2].divide(shared)
        };
    }

    /**
     * The area that it covers of a sphere of radius 1 round the eye, by flat triangles, rounded.
     */
    double size() {
        double sum = 0;
        for (int i = 1; i + 1 < rays.size(); i++)
            sum += triangle(rays.get(0), rays.get(i), rays.get(i + 1));
        return sum;
    }

    /** ½·|det(a, b, c)| / (|a|·|b|·|c|), which is the area of a small triangle on the sphere. */
    private static double triangle(BigInteger[] a, BigInteger[] b, BigInteger[] c) {
        BigInteger det = dot(cross(a, b), c).abs();
        int shift = bits(a) + bits(b) + bits(c);
        return scaled(det, shift) / (2 * length(a) * length(b) * length(c));
    }

    private static int bits(BigInteger[] ray) {
        return Math.max(ray[0].bitLength(), Math.max(ray[1].bitLength(), ray[2].bitLength()));
    }

    /** |ray| / 2^bits. */
    private static double length(BigInteger[] ray) {
        double x = scaled(ray[0], bits(ray));
        double y = scaled(ray[1], bits(ray));
        double z = scaled(ray[2], bits(ray));
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** value / 2^shift, to 60 bits. */
    private static double scaled(BigInteger value, int shift) {
        int drop = Math.max(0, value.bitLength() - 60);
        return Math.scalb(value.shiftRight(drop).doubleValue(), drop - shift);
    }

    static BigInteger[] cross(BigInteger[] a, BigInteger[] b) {
        var cross = new BigInteger[3];
        for (int axis = 0; axis < 3; axis++) {
            int u = (axis + 1) % 3;
            int v = (axis + 2) % 3;
            cross[axis] = a[u].multiply(b[v]).subtract(a[v].multiply(b[u]));
        }
        return cross;
    }

    static BigInteger dot(BigInteger[] a, BigInteger[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    static BigInteger[] negated(BigInteger[] a) {
        return new BigInteger[] {a[0].negate(), a[1].negate(), a[2].negate()};
    }
}
