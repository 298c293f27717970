import rasterlab.contract.*;

public class MyMethod implements PointShader {

    static double[] unit(double[] v, String name) {
        double m = Math.max(Math.abs(v[0]), Math.max(Math.abs(v[1]), Math.abs(v[2])));
        if (m == 0) throw new IllegalArgumentException(name + " is zero");
        double x = v[0] / m, y = v[1] / m, z = v[2] / m, l = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / l, y / l, z / l};
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    public double[] intensity(LitPoint p) {
        double[] n = unit(p.normal(), "normal"), l = unit(p.toLight(), "toLight");
        SurfaceMaterial m = p.material();
        LightSource s = p.light();
        double f = s.attenuation().factor(p.distance());
        if (Double.isInfinite(f)) throw new IllegalArgumentException("the light is in the point");
        double g = 1;
        if (!s.cone().shinesAllAround()) {
            double[] a = unit(s.cone().direction(), "cone");
            double c = -dot(a, l);
            g =
                    c < Math.cos(Math.toRadians(s.cone().cutoff()))
                            ? 0
                            : Math.pow(c, s.cone().exponent());
        }
        double nl = dot(n, l), high = 0;
        if (nl > 0) {
            double[] v = unit(p.toEye(), "toEye");
            high = Math.max(0, 2 * nl * dot(n, v) - dot(l, v));
        }
        double[] r = new double[3];
        for (int k = 0; k < 3; k++) {
            double i =
                    m.emission()[k]
                            + p.globalAmbient()[k] * m.ambient()[k]
                            + f
                                    * g
                                    * (s.ambient()[k] * m.ambient()[k]
                                            + s.diffuse()[k] * m.diffuse()[k] * Math.max(0, nl)
                                            + s.specular()[k] * m.specular()[k] * high);
            r[k] = Math.max(0, Math.min(1, i));
        }
        return r;
    }
}
