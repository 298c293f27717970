import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;

/** Wrong: takes the cosine without its sign (sign-dropped). */
public class WrongSignDropped implements PointShader {
    @Override
    public double[] intensity(LitPoint p) {
        double[] n = unit(p.normal());
        double[] l = unit(p.toLight());
        double nl = Math.abs(dot(n, l));
        double f = p.light().attenuation().factor(p.distance());
        if (Double.isInfinite(f)) throw new IllegalArgumentException("light in the point");
        if (!p.light().cone().shinesAllAround()) {
            double c = -dot(unit(p.light().cone().direction()), l);
            if (c < Math.cos(Math.toRadians(p.light().cone().cutoff()))) f = 0;
            else f *= Math.pow(c, p.light().cone().exponent());
        }
        double shine = 0;
        if (nl > 0) {
            double[] v = unit(p.toEye());
            double rv = 2 * dot(n, l) * dot(n, v) - dot(l, v);
            shine = Math.pow(Math.max(0, rv), p.material().shininess());
        }
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            double own = p.light().ambient()[i] * p.material().ambient()[i];
            own += p.light().diffuse()[i] * p.material().diffuse()[i] * Math.max(0, nl);
            own += p.light().specular()[i] * p.material().specular()[i] * shine;
            rgb[i] = p.material().emission()[i] + p.globalAmbient()[i] * p.material().ambient()[i];
            rgb[i] = Math.min(1, rgb[i] + f * own);
        }
        return rgb;
    }

    private static double[] unit(double[] a) {
        double length = Math.hypot(Math.hypot(a[0], a[1]), a[2]);
        if (length == 0) throw new IllegalArgumentException("no direction");
        return new double[] {a[0] / length, a[1] / length, a[2] / length};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
