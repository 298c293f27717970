package rasterlab.engine.visibility.order;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.ArrayList;
import java.util.List;

/**
 * The plane of a polygon for the reference, in whole numbers and relative to the eye: n·p = c with
 * c ≥ 0; c = 0 where it is seen edge on.
 */
final class ExactPolygon {
    /** One is nearer than another if by more than 2⁻⁴⁰ of its distance, about 10⁻¹². */
    private static final int LEVEL_BITS = 40;

    private final BigInteger[] normal;
    private final BigInteger c;

    ExactPolygon(List<BigInteger[]> corners) {
        var sum = new BigInteger[] {BigInteger.ZERO, BigInteger.ZERO, BigInteger.ZERO};
        for (int i = 0; i < corners.size(); i++) {
            BigInteger[] cross =
                    ExactCone.cross(corners.get(i), corners.get((i + 1) % corners.size()));
            for (int axis = 0; axis < 3; axis++) sum[axis] = sum[axis].add(cross[axis]);
        }
        BigInteger at = ExactCone.dot(sum, corners.get(0));
        normal = at.signum() < 0 ? ExactCone.negated(sum) : sum;
        c = at.abs();
    }

    boolean edgeOn() {
        return c.signum() == 0;
    }

    /**
     * The h with h·r &gt; 0 on the rays r on which this is nearer than the other: 1/t is n·r/c on
     * the ray t·r.
     */
    BigInteger[] nearerThan(ExactPolygon other) {
        BigInteger one = BigInteger.ONE.shiftLeft(LEVEL_BITS);
        BigInteger mine = other.c.multiply(one);
        BigInteger others = c.multiply(one.add(BigInteger.ONE));
        var h = new BigInteger[3];
        for (int axis = 0; axis < 3; axis++)
            h[axis] = normal[axis].multiply(mine).subtract(other.normal[axis].multiply(others));
        return h;
    }

    /** Corners less the eye, times 2 to the power of {@code bits}, which makes them whole. */
    static List<BigInteger[]> fromEye(double[] corners, double[] eye, int bits) {
        var all = new ArrayList<BigInteger[]>();
        for (int i = 0; i < corners.length; i += 3) {
            var corner = new BigInteger[3];
            for (int axis = 0; axis < 3; axis++)
                corner[axis] = whole(corners[i + axis], bits).subtract(whole(eye[axis], bits));
            all.add(corner);
        }
        return all;
    }

    private static BigInteger whole(double value, int bits) {
        if (value == 0) return BigInteger.ZERO;
        int down = 52 - Math.max(Math.getExponent(value), Double.MIN_EXPONENT);
        long mantissa = new BigDecimal(Math.scalb(value, down)).longValueExact();
        return BigInteger.valueOf(mantissa).shiftLeft(bits - down);
    }

    /** The bits behind the point that doubles have: value·2^bits is whole. */
    static int bits(double[] values) {
        int most = 0;
        for (double value : values)
            if (value != 0)
                most = Math.max(most, 52 - Math.max(Math.getExponent(value), Double.MIN_EXPONENT));
        return most;
    }
}
