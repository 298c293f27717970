package rasterlab.engine.light.shade;

import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;

/**
 * The formula as printed, {@code I = I_p·kₐ + I_p/(R + r²)·(k_d·(L, N) + k_m·(R, V)ⁿ)}: vectors are
 * taken to have length 1, a negative cosine is as good as any, the distance does not weaken the
 * light's ambient term, and the sum is not cut.
 *
 * <p>Source: A. V. Kazantsev, Foundations of computer graphics for programmers, Kazan, 2005, ch. 7.
 */
final class PrintedShader implements PointShader, TermShader {
    @Override
    public double[] intensity(LitPoint point) {
        return terms(point).sum();
    }

    @Override
    public Terms terms(LitPoint point) {
        double[] n = point.normal();
        double[] l = point.toLight();
        double[] v = point.toEye();
        double nl = dot(n, l);
        double mirrored = 2 * nl * dot(n, v) - dot(l, v);
        double attenuation = point.light().attenuation().factor(point.distance());
        var material = point.material();
        var light = point.light();
        return new Terms(
                material.emission(),
                product(point.globalAmbient(), material.ambient(), 1),
                product(light.ambient(), material.ambient(), 1),
                product(light.diffuse(), material.diffuse(), attenuation * nl),
                product(
                        light.specular(),
                        material.specular(),
                        attenuation * Math.pow(mirrored, material.shininess())),
                attenuation,
                1);
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] product(double[] light, double[] surface, double factor) {
        return new double[] {
            light[0] * surface[0] * factor,
            light[1] * surface[1] * factor,
            light[2] * surface[2] * factor
        };
    }
}
