package rasterlab.engine.pipeline;

import static rasterlab.engine.pipeline.PlainRays.dot;
import static rasterlab.engine.pipeline.PlainRays.length;
import static rasterlab.engine.pipeline.PlainRays.minus;
import static rasterlab.engine.pipeline.PlainRays.plus;
import static rasterlab.engine.pipeline.PlainRays.times;
import static rasterlab.engine.pipeline.PlainRays.unit;

import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;

/** The lighting formula, written down once more without any of the renderer's code. */
final class PlainLight {
    private PlainLight() {}

    /** Red, green and blue before they are cut to 0 to 1. */
    static double[] at(
            double[] point,
            double[] normal,
            double[] toEye,
            SurfaceMaterial material,
            LightModel model) {
        double[] n = unit(normal);
        var sum = new double[3];
        for (int c = 0; c < 3; c++)
            sum[c] = material.emission()[c] + material.ambient()[c] * model.globalAmbient()[c];
        for (Light light : model.lights()) {
            double[] place = {light.x(), light.y(), light.z()};
            double[] way = light.directional() ? place : minus(place, point);
            double[] l = unit(way);
            double f = light.directional() ? 1 : reached(light, l, length(way));
            double nl = Math.max(0, dot(n, l));
            double shine = nl > 0 ? shine(model.reflection(), n, l, toEye) : 0;
            for (int c = 0; c < 3; c++)
                sum[c] +=
                        f * material.ambient()[c] * light.source().ambient()[c]
                                + f * nl * material.diffuse()[c] * light.source().diffuse()[c]
                                + f
                                        * Math.pow(shine, material.shininess())
                                        * (nl > 0 && model.reflection() != Reflection.LAMBERT
                                                ? 1
                                                : 0)
                                        * material.specular()[c]
                                        * light.source().specular()[c];
        }
        return sum;
    }

    private static double reached(Light light, double[] l, double d) {
        var fading = light.source().attenuation();
        double f = 1 / (fading.constant() + fading.linear() * d + fading.quadratic() * d * d);
        var cone = light.source().cone();
        if (cone.shinesAllAround()) return f;
        double cosine = dot(times(-1, l), unit(cone.direction()));
        boolean lit = cosine >= Math.cos(Math.toRadians(cone.cutoff()));
        return lit ? f * Math.pow(cosine, cone.exponent()) : 0;
    }

    private static double shine(Reflection reflection, double[] n, double[] l, double[] v) {
        if (reflection == Reflection.BLINN_PHONG) return Math.max(0, dot(n, unit(plus(l, v))));
        double[] r = minus(times(2 * dot(n, l), n), l);
        return Math.max(0, dot(r, v));
    }

    /** The colour as 0xFFRRGGBB. */
    static int argb(double[] shares) {
        int argb = 255;
        for (double share : shares)
            argb = argb << 8 | (int) Math.round(255 * Math.max(0, Math.min(1, share)));
        return argb;
    }
}
