import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;

/** Wrong: forgets to cut the sum (sum-not-cut). */
public class WrongSumNotCut implements PointShader {
    @Override
    public double[] intensity(LitPoint p) {
        double[] n = unit(p.normal());
        double[] l = unit(p.toLight());
        double nl = dot(n, l);
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
            double rv = 2 * nl * dot(n, v) - dot(l, v);
            shine = Math.pow(Math.max(0, rv), p.material().shininess());
        }
        double[] rgb = new double[3];
        for (int i = 0; i < 3; i++) {
            double own = p.light().ambient()[i] * p.material().ambient()[i];
            own += p.light().diffuse()[i] * p.material().diffuse()[i] * Math.max(0, nl);
            own += p.light().specular()[i] * p.material().specular()[i] * shine;
            rgb[i] = p.material().emission()[i] + p.globalAmbient()[i] * p.material().ambient()[i];
            rgb[i] += f * own;
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
