package rasterlab.engine.visibility.faces;

import java.math.BigDecimal;

/**
 * Finds on which side of a face's plane points lie, without error for all finite doubles.
 *
 * <p>With a, b, c running through the triangles of the fan from corner a = c₀, the sign of {@code Σ
 * det(b − a, c − a, p − a)} = 2·n·(p − c₀): 1 in front, where the normal points, −1 behind, 0 in
 * the plane.
 *
 * <p>First in doubles. Each determinant is off by at most (7 + 56·ε)·ε times the sum of its
 * products' sizes, ε = 2⁻⁵³, and adding k of them by k·ε times all those sums; {@link #UNDERFLOW}
 * covers what products near zero can lose. Where the sum does not exceed that bound, or left the
 * range of doubles, decimal numbers of any length decide.
 *
 * <p>Source of the bound: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast
 * robust geometric predicates, Discrete & Computational Geometry 18, 1997, pp. 305–363.
 */
final class FaceSide {
    private static final double EPSILON = 0x1p-53;
    private static final double UNDERFLOW = 0x1p-1060;

    private final double[] xyz;
    private double value;
    private double size;
    private long asked;
    private long exactly;

    FaceSide(double[] xyz) {
        this.xyz = xyz;
    }

    /** The side of the face that point p is on: −1, 0 or 1. */
    int of(int[] face, double px, double py, double pz) {
        asked++;
        int a = 3 * face[0];
        double dx = px - xyz[a];
        double dy = py - xyz[a + 1];
        double dz = pz - xyz[a + 2];
        value = 0;
        size = 0;
        for (int k = 1; k + 1 < face.length; k++)
            addTriangle(a, 3 * face[k], 3 * face[k + 1], dx, dy, dz);
        double near = Math.abs(dx) + Math.abs(dy) + Math.abs(dz);
        double bound = (10 + face.length) * EPSILON * size + face.length * UNDERFLOW * (1 + near);
        if (value > bound) return 1;
        if (value < -bound) return -1;
        exactly++;
        return exact(face, px, py, pz);
    }

    private void addTriangle(int a, int b, int c, double dx, double dy, double dz) {
        double bx = xyz[b] - xyz[a];
        double by = xyz[b + 1] - xyz[a + 1];
        double bz = xyz[b + 2] - xyz[a + 2];
        double cx = xyz[c] - xyz[a];
        double cy = xyz[c + 1] - xyz[a + 1];
        double cz = xyz[c + 2] - xyz[a + 2];
        value += dx * (by * cz - bz * cy) + dy * (bz * cx - bx * cz) + dz * (bx * cy - by * cx);
        size +=
                Math.abs(dx) * (Math.abs(by * cz) + Math.abs(bz * cy))
                        + Math.abs(dy) * (Math.abs(bz * cx) + Math.abs(bx * cz))
                        + Math.abs(dz) * (Math.abs(bx * cy) + Math.abs(by * cx));
    }

    /** Twice n·(p − c₀) for the point asked last, rounded. */
    double value() {
        return value;
    }

    /** Points asked so far. */
    long asked() {
        return asked;
    }

    /** The number of questions that took decimal numbers. */
    long exactly() {
        return exactly;
    }

    private int exact(int[] face, double px, double py, double pz) {
        BigDecimal[] toPoint = difference(face[0], px, py, pz);
        BigDecimal sum = BigDecimal.ZERO;
        for (int k = 1; k + 1 < face.length; k++) {
            BigDecimal[] b = edge(face[0], face[k]);
            BigDecimal[] c = edge(face[0], face[k + 1]);
            for (int axis = 0; axis < 3; axis++) {
                int next = (axis + 1) % 3;
                int last = (axis + 2) % 3;
                BigDecimal cross = b[next].multiply(c[last]).subtract(b[last].multiply(c[next]));
                sum = sum.add(toPoint[axis].multiply(cross));
            }
        }
        return sum.signum();
    }

    private BigDecimal[] edge(int from, int to) {
        return difference(from, xyz[3 * to], xyz[3 * to + 1], xyz[3 * to + 2]);
    }

    private BigDecimal[] difference(int from, double... to) {
        var difference = new BigDecimal[3];
        for (int axis = 0; axis < 3; axis++)
            difference[axis] =
                    new BigDecimal(to[axis]).subtract(new BigDecimal(xyz[3 * from + axis]));
        return difference;
    }
}
