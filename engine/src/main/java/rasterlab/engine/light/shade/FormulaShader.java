package rasterlab.engine.light.shade;

import java.math.BigDecimal;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.engine.light.Powers;
import rasterlab.engine.light.SpecularCosine;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.transform.Angle;

/**
 * The formula with every direction brought to length 1 first and every cosine cut at 0.
 *
 * <p>Sources: J. H. Lambert, Photometria, 1760; A. V. Kazantsev, Foundations of computer graphics
 * for programmers, Kazan, 2005, ch. 7, empirical model; B. T. Phong, Illumination for computer
 * generated pictures, Communications of the ACM 18(6), 1975, pp. 311–317; J. F. Blinn, Models of
 * light reflection for computer synthesized pictures, SIGGRAPH 1977, pp. 192–198.
 */
public final class FormulaShader implements PointShader, TermShader {
    /** A computed n·l nearer to 0 may have the wrong sign. */
    private static final double SURE = 1e-14;

    /** A cosine nearer to 0 has too few right digits for a power below 1. */
    private static final double STEEP = 1e-6;

    private final Reflection reflection;

    public FormulaShader(Reflection reflection) {
        this.reflection = reflection;
    }

    @Override
    public Reflection reflection() {
        return reflection;
    }

    @Override
    public double[] intensity(LitPoint point) {
        return terms(point).intensity();
    }

    /**
     * The intensity of a point whose normal and way to the light are rounded.
     *
     * @param lit whether n·l is above 0 before that
     */
    public double[] intensity(LitPoint point, boolean lit) {
        double[] n = unit("normal", point.normal());
        double[] l = unit("to-light", point.toLight());
        return terms(point, n, l, lit).intensity();
    }

    @Override
    public Terms terms(LitPoint point) {
        double[] n = unit("normal", point.normal());
        double[] l = unit("to-light", point.toLight());
        return terms(point, n, l, isLit(point, n, l));
    }

    private Terms terms(LitPoint point, double[] n, double[] l, boolean lit) {
        double attenuation = attenuation(point);
        double cone = cone(point.light().cone(), l);
        double strength = attenuation * cone;
        double cosine = Math.max(0, n[0] * l[0] + n[1] * l[1] + n[2] * l[2]);
        double mirrored = lit ? mirrored(point, n, l) : 0;
        var material = point.material();
        var light = point.light();
        return new Terms(
                material.emission(),
                product(point.globalAmbient(), material.ambient(), 1),
                product(light.ambient(), material.ambient(), strength),
                product(light.diffuse(), material.diffuse(), strength * cosine),
                product(light.specular(), material.specular(), strength * mirrored),
                attenuation,
                cone);
    }

    /** Whether n·l is above 0, on which the whole specular term hangs: never left to rounding. */
    private static boolean isLit(LitPoint point, double[] n, double[] l) {
        double cosine = n[0] * l[0] + n[1] * l[1] + n[2] * l[2];
        if (Math.abs(cosine) > SURE) return cosine > 0;
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < 3; i++)
            sum =
                    sum.add(
                            new BigDecimal(point.normal()[i])
                                    .multiply(new BigDecimal(point.toLight()[i])));
        return sum.signum() > 0;
    }

    private double mirrored(LitPoint point, double[] n, double[] l) {
        if (reflection == Reflection.LAMBERT) return 0;
        double[] v = unit("to-eye", point.toEye());
        double cosine =
                SpecularCosine.cosine(
                        reflection, n[0], n[1], n[2], l[0], l[1], l[2], v[0], v[1], v[2]);
        double shininess = point.material().shininess();
        boolean steep = shininess > 0 && shininess < 1 && cosine < STEEP;
        return steep && reflection == Reflection.PHONG
                ? ExactMirror.power(point, shininess)
                : Powers.of(cosine, shininess);
    }

    private static double attenuation(LitPoint point) {
        var attenuation = point.light().attenuation();
        double factor = attenuation.factor(point.distance());
        if (factor == Double.POSITIVE_INFINITY)
            throw new IllegalArgumentException(
                    "constant + linear·d + quadratic·d² must be above 5.6e-309, got %s at distance %s"
                            .formatted(divisor(attenuation, point.distance()), point.distance()));
        return factor;
    }

    /** A divisor that is not above 5.6·10⁻³⁰⁹ makes of 1 more than the largest double. */
    private static double divisor(Attenuation of, double distance) {
        return of.constant() + distance * (of.linear() + distance * of.quadratic());
    }

    private static double cone(SpotCone cone, double[] l) {
        if (cone.shinesAllAround()) return 1;
        double[] axis = unit("spot direction", cone.direction());
        double cosine = -(axis[0] * l[0] + axis[1] * l[1] + axis[2] * l[2]);
        if (cosine < Angle.ofDegrees(cone.cutoff()).cos()) return 0;
        return Powers.of(cosine, cone.exponent());
    }

    private static double[] unit(String name, double[] vector) {
        double[] unit = vector.clone();
        if (!UnitVector.normalize(unit))
            throw new IllegalArgumentException(name + " must not be zero, got (0, 0, 0)");
        return unit;
    }

    private static double[] product(double[] light, double[] surface, double factor) {
        return new double[] {
            light[0] * surface[0] * factor,
            light[1] * surface[1] * factor,
            light[2] * surface[2] * factor
        };
    }
}
