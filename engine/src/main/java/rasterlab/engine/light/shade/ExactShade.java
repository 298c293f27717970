package rasterlab.engine.light.shade;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.engine.transform.exact.BigTrig;

/** The formula of {@link rasterlab.contract.PointShader} in decimals of 60 digits. */
public final class ExactShade {
    private static final MathContext DIGITS = BigTrig.DIGITS;
    private static final BigDecimal ONE = BigDecimal.ONE;
    private static final BigDecimal ZERO = BigDecimal.ZERO;

    /** Cosines below have powers of 1 or more that are no doubles. */
    private static final BigDecimal TINY = new BigDecimal("1e-400");

    private ExactShade() {}

    /** Three shares, or NaN where the contract refuses. */
    public static double[] intensity(LitPoint point, Reflection reflection) {
        return intensity(point, reflection, isLit(point));
    }

    /** Whether n·l is above 0; rounding to directions of length 1 could make 0 a little more. */
    private static boolean isLit(LitPoint point) {
        BigDecimal sum = ZERO;
        for (int i = 0; i < 3; i++) sum = sum.add(product(point.normal()[i], point.toLight()[i]));
        return sum.signum() > 0;
    }

    /**
     * {@link #intensity(LitPoint, Reflection)} of a point whose normal and way to the light are
     * rounded.
     *
     * @param lit whether n·l is above 0 before that
     */
    public static double[] intensity(LitPoint point, Reflection reflection, boolean lit) {
        double[] nothing = {Double.NaN, Double.NaN, Double.NaN};
        boolean mirrors = reflection != Reflection.LAMBERT;
        if (isZero(point.normal()) || isZero(point.toLight())) return nothing;
        BigDecimal divisor = divisor(point.light().attenuation(), point.distance());
        if (divisor.signum() == 0) return nothing;
        BigDecimal[] n = unit(point.normal());
        BigDecimal[] l = unit(point.toLight());
        BigDecimal nl = dot(n, l);
        BigDecimal strength = cone(point.light().cone(), l).divide(divisor, DIGITS);
        BigDecimal mirrored = ZERO;
        if (mirrors && lit) {
            if (isZero(point.toEye())) return nothing;
            mirrored = power(ExactCosine.of(point, reflection), point.material().shininess());
        }
        return sum(point, strength, nl.max(ZERO), mirrored);
    }

    private static double[] sum(
            LitPoint point, BigDecimal strength, BigDecimal cosine, BigDecimal mirrored) {
        var rgb = new double[3];
        var material = point.material();
        var light = point.light();
        for (int c = 0; c < 3; c++) {
            BigDecimal own =
                    product(light.ambient()[c], material.ambient()[c])
                            .add(
                                    product(light.diffuse()[c], material.diffuse()[c])
                                            .multiply(cosine))
                            .add(
                                    product(light.specular()[c], material.specular()[c])
                                            .multiply(mirrored));
            rgb[c] =
                    own.multiply(strength)
                            .add(product(point.globalAmbient()[c], material.ambient()[c]))
                            .add(new BigDecimal(material.emission()[c]))
                            .min(ONE)
                            .doubleValue();
        }
        return rgb;
    }

    private static BigDecimal divisor(Attenuation by, double distance) {
        BigDecimal d = new BigDecimal(distance);
        return new BigDecimal(by.constant())
                .add(new BigDecimal(by.linear()).multiply(d))
                .add(new BigDecimal(by.quadratic()).multiply(d).multiply(d));
    }

    private static BigDecimal cone(SpotCone cone, BigDecimal[] l) {
        if (cone.shinesAllAround()) return ONE;
        BigDecimal cosine = dot(unit(cone.direction()), l).negate();
        if (cosine.compareTo(BigTrig.ofDegrees(cone.cutoff()).cos()) < 0) return ZERO;
        return power(cosine, cone.exponent());
    }

    /** A power: its whole part by multiplying, the bits behind the point by square roots. */
    private static BigDecimal power(BigDecimal base, double exponent) {
        if (exponent == 0) return ONE;
        int whole = (int) exponent;
        if (base.signum() <= 0 || whole > 0 && base.compareTo(TINY) < 0) return ZERO;
        BigDecimal power = base.round(DIGITS).pow(whole, DIGITS);
        BigDecimal root = base;
        for (double rest = exponent - whole; rest > 0 && rest > 1e-30; ) {
            root = root.sqrt(DIGITS);
            rest *= 2;
            if (rest >= 1) {
                power = power.multiply(root, DIGITS);
                rest -= 1;
            }
        }
        return power;
    }

    private static BigDecimal[] unit(double[] vector) {
        var big = new BigDecimal[3];
        for (int i = 0; i < 3; i++) big[i] = new BigDecimal(vector[i]);
        BigDecimal length = dot(big, big).sqrt(DIGITS);
        for (int i = 0; i < 3; i++) big[i] = big[i].divide(length, DIGITS);
        return big;
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    private static BigDecimal product(double a, double b) {
        return new BigDecimal(a).multiply(new BigDecimal(b));
    }

    private static boolean isZero(double[] v) {
        return v[0] == 0 && v[1] == 0 && v[2] == 0;
    }
}
