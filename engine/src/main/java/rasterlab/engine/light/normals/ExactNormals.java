package rasterlab.engine.light.normals;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import rasterlab.engine.transform.exact.BigTrig;

/**
 * Means by angles in decimals of 60 digits; only the angles themselves are rounded to doubles.
 *
 * <p>Angles are the weights to hold others against because their means belong to the surface: a
 * flat face may be cut into triangles in any way, its angles at a vertex keep their sum.
 */
final class ExactNormals {
    private static final MathContext DIGITS = BigTrig.DIGITS;
    private static final BigDecimal CANCELLED = new BigDecimal("1e-9");

    private ExactNormals() {}

    static double[] of(TriangleSurface surface) {
        int count = surface.vertices().length / 3;
        var sums = new BigDecimal[count][];
        for (int i = 0; i < count; i++) sums[i] = zero();
        var weights = new double[count];
        int[] corners = surface.triangles();
        for (int face = 0; face < corners.length; face += 3)
            for (int k = 0; k < 3; k++) {
                int vertex = corners[face + k];
                BigDecimal[] p = edge(surface, vertex, corners[face + (k + 1) % 3]);
                BigDecimal[] q = edge(surface, vertex, corners[face + (k + 2) % 3]);
                BigDecimal[] normal = cross(p, q);
                BigDecimal length = length(normal);
                if (length.signum() == 0) continue;
                double angle = angle(length, dot(p, q));
                weights[vertex] += angle;
                for (int c = 0; c < 3; c++)
                    sums[vertex][c] =
                            sums[vertex][c].add(
                                    normal[c]
                                            .divide(length, DIGITS)
                                            .multiply(new BigDecimal(angle)));
            }
        return unit(sums, weights);
    }

    private static double[] unit(BigDecimal[][] sums, double[] weights) {
        var normals = new double[3 * sums.length];
        for (int i = 0; i < sums.length; i++) {
            BigDecimal length = length(sums[i]);
            if (length.compareTo(CANCELLED.multiply(new BigDecimal(weights[i]))) <= 0) continue;
            for (int c = 0; c < 3; c++)
                normals[3 * i + c] = sums[i][c].divide(length, DIGITS).doubleValue();
        }
        return normals;
    }

    private static double angle(BigDecimal cross, BigDecimal dot) {
        BigDecimal scale = cross.max(dot.abs());
        return StrictMath.atan2(
                cross.divide(scale, DIGITS).doubleValue(), dot.divide(scale, DIGITS).doubleValue());
    }

    private static BigDecimal[] edge(TriangleSurface surface, int from, int to) {
        var edge = new BigDecimal[3];
        double[] xyz = surface.vertices();
        for (int c = 0; c < 3; c++)
            edge[c] = new BigDecimal(xyz[3 * to + c]).subtract(new BigDecimal(xyz[3 * from + c]));
        return edge;
    }

    private static BigDecimal[] cross(BigDecimal[] p, BigDecimal[] q) {
        var cross = new BigDecimal[3];
        for (int c = 0; c < 3; c++) {
            int next = (c + 1) % 3;
            int last = (c + 2) % 3;
            cross[c] = p[next].multiply(q[last]).subtract(p[last].multiply(q[next]));
        }
        return cross;
    }

    private static BigDecimal dot(BigDecimal[] p, BigDecimal[] q) {
        return p[0].multiply(q[0]).add(p[1].multiply(q[1])).add(p[2].multiply(q[2]));
    }

    private static BigDecimal length(BigDecimal[] v) {
        return dot(v, v).sqrt(DIGITS);
    }

    private static BigDecimal[] zero() {
        var zero = new BigDecimal[3];
        Arrays.fill(zero, BigDecimal.ZERO);
        return zero;
    }
}
