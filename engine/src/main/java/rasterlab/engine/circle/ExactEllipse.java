package rasterlab.engine.circle;

import java.math.BigInteger;
import rasterlab.contract.Pixels;

/**
 * The right pixels of an ellipse (a circle being one with equal half-axes), from the definition, in
 * unbounded integers.
 *
 * <p>The row nearest to b·√(1 − u²/a²), a tie to the smaller, is the least v with v + ½ ≥ it, that
 * is with a²·(2·v + 1)² ≥ 4·b²·(a² − u²); the like for columns. Shares no code with the methods it
 * judges.
 */
public final class ExactEllipse {
    private final int a;
    private final int b;

    /**
     * @param a half-axis along the rows in pixels, at least 0
     * @param b half-axis along the columns in pixels, at least 0
     */
    public ExactEllipse(int a, int b) {
        this.a = a;
        this.b = b;
    }

    /** Sends all pixels of the ellipse about (centreX, centreY), each once. */
    public void draw(int centerX, int centerY, Pixels out) {
        quadrant(
                (u, v) -> {
                    out.plot(centerX + u, centerY + v);
                    if (u > 0) out.plot(centerX - u, centerY + v);
                    if (v > 0) out.plot(centerX + u, centerY - v);
                    if (u > 0 && v > 0) out.plot(centerX - u, centerY - v);
                });
    }

    /** Sends the pixels of the quadrant u, v ≥ 0, first those of the columns, each once. */
    public void quadrant(Pixels out) {
        var rows = new int[a + 1];
        int v = b;
        for (int u = 0; u <= a; u++) {
            v = nearest(a, b, u, v);
            rows[u] = v;
            out.plot(u, v);
        }
        int u = a;
        for (int y = 0; y <= b; y++) {
            u = nearest(b, a, y, u);
            if (rows[u] != y) out.plot(u, y);
        }
    }

    /** The row nearest to the curve in column {@code u} of 0..a. */
    int row(int u) {
        return nearest(a, b, u, notBelow(a, b, u));
    }

    /** The column nearest to the curve in row {@code v} of 0..b. */
    int column(int v) {
        return nearest(b, a, v, notBelow(b, a, v));
    }

    /** A whole number that is not below other·√(1 − at²/along²) + ½, by at most 1. */
    private static int notBelow(int along, int other, int at) {
        if (along == 0) return other;
        BigInteger squares = square(along).subtract(square(at)).multiply(square(other));
        return squares.divide(square(along)).sqrt().intValueExact() + 1;
    }

    /**
     * The least whole number w ≥ 0 with w + ½ ≥ other·√(1 − at²/along²).
     *
     * @param from a number that is not below it
     */
    private static int nearest(int along, int other, int at, int from) {
        if (along == 0) return other;
        BigInteger bound = square(other).multiply(square(along).subtract(square(at))).shiftLeft(2);
        int w = from;
        while (w > 0 && square(along).multiply(square(2L * w - 1)).compareTo(bound) >= 0) w--;
        return w;
    }

    private static BigInteger square(long value) {
        return BigInteger.valueOf(value).pow(2);
    }
}
