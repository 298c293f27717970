package rasterlab.engine.visibility.faces;

import java.math.BigInteger;

/**
 * The reference: the sign of n·(eye − c₀) in whole numbers.
 *
 * <p>All coordinates are multiplied by 2¹⁰⁷⁴, which makes every double a whole number and changes
 * no sign. The normal is the sum of the cross products of the corners themselves, {@code Σ cᵢ ×
 * cᵢ₊₁}, not of their differences.
 */
final class ExactFaces {
    private final BigInteger[] xyz;
    private final BigInteger[] eye;

    ExactFaces(Body body) {
        xyz = whole(body.xyz());
        eye = whole(body.eye());
    }

    private static BigInteger[] whole(double[] values) {
        var whole = new BigInteger[values.length];
        for (int i = 0; i < values.length; i++) whole[i] = whole(values[i]);
        return whole;
    }

    /** value·2¹⁰⁷⁴, from the bits of the double. */
    private static BigInteger whole(double value) {
        long bits = Double.doubleToLongBits(value);
        int exponent = (int) (bits >>> 52 & 0x7ff);
        long mantissa = bits & 0xfffffffffffffL;
        if (exponent > 0) mantissa |= 1L << 52;
        BigInteger size = BigInteger.valueOf(mantissa).shiftLeft(Math.max(exponent, 1) - 1);
        return bits < 0 ? size.negate() : size;
    }

    boolean visible(int[] face) {
        BigInteger sum = BigInteger.ZERO;
        for (int axis = 0; axis < 3; axis++) {
            BigInteger toEye = eye[axis].subtract(xyz[3 * face[0] + axis]);
            sum = sum.add(toEye.multiply(normal(face, axis)));
        }
        return sum.signum() > 0;
    }

    private BigInteger normal(int[] face, int axis) {
        BigInteger sum = BigInteger.ZERO;
        for (int k = 0; k < face.length; k++) {
            int p = 3 * face[k];
            int q = 3 * face[(k + 1) % face.length];
            int u = (axis + 1) % 3;
            int v = (axis + 2) % 3;
            sum =
                    sum.add(xyz[p + u].multiply(xyz[q + v]))
                            .subtract(xyz[p + v].multiply(xyz[q + u]));
        }
        return sum;
    }
}
