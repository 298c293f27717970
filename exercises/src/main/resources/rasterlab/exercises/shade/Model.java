import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;

/** Brings every direction to length 1 first, then adds the terms one by one. */
public class Model implements PointShader {
    @Override
    public double[] intensity(LitPoint point) {
        double[] n = unit("normal", point.normal());
        double[] l = unit("to-light", point.toLight());
        SurfaceMaterial material = point.material();
        LightSource light = point.light();
        double strength = weakened(light.attenuation(), point.distance()) * cone(light.cone(), l);
        double cosine = dot(n, l);
        double mirrored = cosine > 0 ? mirrored(n, l, cosine, point) : 0;
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            double own =
                    light.ambient()[i] * material.ambient()[i]
                            + light.diffuse()[i] * material.diffuse()[i] * Math.max(0, cosine)
                            + light.specular()[i] * material.specular()[i] * mirrored;
            double sum =
                    material.emission()[i]
                            + point.globalAmbient()[i] * material.ambient()[i]
                            + strength * own;
            rgb[i] = Math.min(1, sum);
        }
        return rgb;
    }

    private static double mirrored(double[] n, double[] l, double cosine, LitPoint point) {
        double[] v = unit("to-eye", point.toEye());
        double rv = 2 * cosine * dot(n, v) - dot(l, v);
        return Math.pow(Math.max(0, rv), point.material().shininess());
    }

    private static double weakened(Attenuation by, double distance) {
        double factor = by.factor(distance);
        if (Double.isInfinite(factor))
            throw new IllegalArgumentException("the light stands in the point: distance " + distance);
        return factor;
    }

    private static double cone(SpotCone cone, double[] l) {
        if (cone.shinesAllAround()) return 1;
        double cosine = -dot(unit("spot direction", cone.direction()), l);
        return cosine < Math.cos(Math.toRadians(cone.cutoff()))
                ? 0
                : Math.pow(Math.max(0, cosine), cone.exponent());
    }

    /**
     * The vector of length 1, divided by its largest number first, so that no square overflows or
     * vanishes.
     */
    private static double[] unit(String name, double[] v) {
        double largest = Math.max(Math.abs(v[0]), Math.max(Math.abs(v[1]), Math.abs(v[2])));
        if (largest == 0) throw new IllegalArgumentException(name + " must not be (0, 0, 0)");
        double[] unit = {v[0] / largest, v[1] / largest, v[2] / largest};
        double length = Math.sqrt(dot(unit, unit));
        for (int i = 0; i < 3; i++) unit[i] /= length;
        return unit;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
