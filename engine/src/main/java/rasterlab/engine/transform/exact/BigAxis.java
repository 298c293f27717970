package rasterlab.engine.transform.exact;

import static rasterlab.engine.transform.exact.BigTrig.DIGITS;

import java.math.BigDecimal;

/**
 * Rotation about a line, to many digits: what lies along the axis stays, what lies across it turns.
 *
 * <p>With v = p − A and u along the axis, of any length: along = u·(u·v)/(u·u), across = v − along,
 * p' = A + along + across·cos + (u × v)·sin/|u|.
 */
public final class BigAxis {
    private final BigDecimal[] through;
    private final BigDecimal[] u;
    private final BigDecimal square;
    private final BigDecimal sinByLength;
    private final BigDecimal cos;

    /**
     * @throws IllegalArgumentException if the direction is zero
     */
    public BigAxis(double[] through, double[] direction, double degrees) {
        if (direction[0] == 0 && direction[1] == 0 && direction[2] == 0)
            throw new IllegalArgumentException("direction must not be zero, got (0, 0, 0)");
        this.through = big(through);
        u = big(direction);
        square = dot(u, u).round(DIGITS);
        BigTrig angle = BigTrig.ofDegrees(degrees);
        sinByLength = angle.sin().divide(square.sqrt(DIGITS), DIGITS);
        cos = angle.cos();
    }

    /** The image of a point. */
    public BigDecimal[] image(BigDecimal[] p) {
        var v = new BigDecimal[3];
        for (int i = 0; i < 3; i++) v[i] = p[i].subtract(through[i]);
        BigDecimal share = dot(u, v).divide(square, DIGITS);
        var image = new BigDecimal[3];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            BigDecimal cross = u[j].multiply(v[k]).subtract(u[k].multiply(v[j]));
            BigDecimal along = u[i].multiply(share);
            image[i] =
                    through[i]
                            .add(along)
                            .add(v[i].subtract(along).multiply(cos))
                            .add(cross.multiply(sinByLength));
        }
        return image;
    }

    static BigDecimal[] big(double... values) {
        var big = new BigDecimal[values.length];
        for (int i = 0; i < values.length; i++) big[i] = new BigDecimal(values[i]);
        return big;
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }
}
