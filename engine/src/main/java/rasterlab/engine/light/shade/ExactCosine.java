package rasterlab.engine.light.shade;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.engine.transform.exact.BigTrig;

/**
 * The cosine of the reference's specular term, from directions as they are given. Nothing is
 * rounded before its sign is sure: an exponent next to 0 makes 1 of the smallest cosine above 0.
 */
final class ExactCosine {
    private static final MathContext DIGITS = BigTrig.DIGITS;
    private static final BigDecimal TWO = BigDecimal.valueOf(2);

    /** |l + v|² below which the contract's c is 0: the two are opposite within rounding. */
    private static final BigDecimal OPPOSITE = new BigDecimal(0x1p-80);

    private final BigDecimal[] n;
    private final BigDecimal[] l;
    private final BigDecimal[] v;

    private ExactCosine(LitPoint point) {
        n = big(point.normal());
        l = big(point.toLight());
        v = big(point.toEye());
    }

    /** The contract's c to 60 digits; 0 where it is negative. */
    static BigDecimal of(LitPoint point, Reflection reflection) {
        var cosine = new ExactCosine(point);
        BigDecimal signed =
                reflection == Reflection.PHONG ? cosine.ofMirrored() : cosine.ofMiddle();
        return signed.max(BigDecimal.ZERO);
    }

    /** r·v = (2·(n·l)·(n·v) − (l·v)·(n·n)) / (|n|²·|l|·|v|). */
    private BigDecimal ofMirrored() {
        BigDecimal twice = dot(n, l).multiply(dot(n, v)).multiply(TWO);
        BigDecimal scaled = twice.subtract(dot(l, v).multiply(dot(n, n)));
        return scaled.divide(dot(n, n).multiply(length(l)).multiply(length(v)), DIGITS);
    }

    /** n·h = ((n·l)·|v| + (n·v)·|l|) / (|n|·|l|·|v|·|h|), with h = l/|l| + v/|v|. */
    private BigDecimal ofMiddle() {
        BigDecimal lengths = length(l).multiply(length(v));
        BigDecimal square = TWO.add(dot(l, v).multiply(TWO).divide(lengths, DIGITS));
        if (square.compareTo(OPPOSITE) < 0) return BigDecimal.ZERO;
        return sum().divide(lengths.multiply(length(n)).multiply(square.sqrt(DIGITS)), DIGITS);
    }

    /** (n·l)·|v| + (n·v)·|l|; as difference of squares, which have no roots, where it cancels. */
    private BigDecimal sum() {
        BigDecimal nl = dot(n, l);
        BigDecimal nv = dot(n, v);
        BigDecimal one = nl.multiply(length(v));
        BigDecimal other = nv.multiply(length(l));
        if (nl.signum() * nv.signum() >= 0) return one.add(other);
        BigDecimal squares = nl.pow(2).multiply(dot(v, v)).subtract(nv.pow(2).multiply(dot(l, l)));
        return squares.divide(one.subtract(other), DIGITS);
    }

    private static BigDecimal length(BigDecimal[] vector) {
        return dot(vector, vector).round(DIGITS).sqrt(DIGITS);
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    private static BigDecimal[] big(double[] vector) {
        return new BigDecimal[] {
            new BigDecimal(vector[0]), new BigDecimal(vector[1]), new BigDecimal(vector[2])
        };
    }
}
