package rasterlab.engine.visibility.order;

/**
 * The normal of a flat polygon, right to the last digits however narrow it is.
 *
 * <p>Computed from rounded edges, the normal of a triangle with sides of 1000 and 10⁻⁴ is off by
 * 10⁷·2⁻⁵³, and its own far corner lies off its plane. So an edge is kept as the rounded difference
 * and what that lost, which is a double too, and a difference of two products is computed with the
 * error of the second added back.
 *
 * <p>Sources: D. E. Knuth, The Art of Computer Programming, vol. 2, 1997, 4.2.2, Theorem B; C.-P.
 * Jeannerod, N. Louvet, J.-M. Muller, Further analysis of Kahan's algorithm for the accurate
 * computation of 2×2 determinants, Mathematics of Computation 82, 2013, pp. 2245–2264.
 */
final class NarrowNormal {
    private final double[] xyz;

    private NarrowNormal(double[] xyz) {
        this.xyz = xyz;
    }

    /**
     * The normal, of length 1.
     *
     * @param xyz of each corner, which go round an area
     */
    static double[] of(double[] xyz) {
        var polygon = new NarrowNormal(xyz);
        double[] normal = {polygon.area(1, 2), polygon.area(2, 0), polygon.area(0, 1)};
        double size = Math.sqrt(polygon.square(normal));
        for (int axis = 0; axis < 3; axis++) normal[axis] /= size;
        return normal;
    }

    private double square(double[] v) {
        return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    }

    /** Twice the area of the fan from corner 0, seen along the third axis. */
    private double area(int axis, int next) {
        double sum = 0;
        for (int k = 1; k + 1 < xyz.length / 3; k++)
            sum +=
                    cross(
                            edge(k, axis),
                            lost(k, axis),
                            edge(k, next),
                            lost(k, next),
                            edge(k + 1, axis),
                            lost(k + 1, axis),
                            edge(k + 1, next),
                            lost(k + 1, next));
        return sum;
    }

    /** a·d − b·c of numbers that each have a lost part. */
    private static double cross(
            double a,
            double aLost,
            double b,
            double bLost,
            double c,
            double cLost,
            double d,
            double dLost) {
        double second = b * c;
        double lostOfSecond = Math.fma(-b, c, second);
        double difference = Math.fma(a, d, -second) + lostOfSecond;
        return difference + ((a * dLost + aLost * d) - (b * cLost + bLost * c));
    }

    /** Corner k less corner 0, rounded. */
    private double edge(int k, int axis) {
        return xyz[3 * k + axis] - xyz[axis];
    }

    /** The part that rounding took from that difference. */
    private double lost(int k, int axis) {
        double to = xyz[3 * k + axis];
        double from = xyz[axis];
        double edge = to - from;
        double fromSeen = edge - to;
        return (to - (edge - fromSeen)) - (from + fromSeen);
    }
}
