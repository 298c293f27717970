import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.contract.LitPoint;
import rasterlab.contract.PointShader;

/** Right: vectors are records, shares a stream, and the mirrored direction itself is made. */
public class RightWithRecords implements PointShader {
    record V(double x, double y, double z) {
        static V of(double[] a) {
            double length = Math.hypot(Math.hypot(a[0], a[1]), a[2]);
            if (length == 0) throw new IllegalArgumentException("a direction is (0, 0, 0)");
            return new V(a[0] / length, a[1] / length, a[2] / length);
        }

        V times(double f) {
            return new V(f * x, f * y, f * z);
        }

        V minus(V o) {
            return new V(x - o.x, y - o.y, z - o.z);
        }

        double dot(V o) {
            return DoubleStream.of(x * o.x, y * o.y, z * o.z).sum();
        }
    }

    @Override
    public double[] intensity(LitPoint p) {
        V n = V.of(p.normal());
        V l = V.of(p.toLight());
        double nl = n.dot(l);
        double f = p.light().attenuation().factor(p.distance());
        if (f > Double.MAX_VALUE) throw new IllegalArgumentException("no distance to the light");
        var cone = p.light().cone();
        if (!cone.shinesAllAround()) {
            double c = V.of(cone.direction()).dot(l.times(-1));
            f *= c < Math.cos(cone.cutoff() * Math.PI / 180) ? 0 : Math.pow(c, cone.exponent());
        }
        double shine = 0;
        if (nl > 0) {
            V r = n.times(2 * nl).minus(l);
            shine = Math.pow(Math.max(r.dot(V.of(p.toEye())), 0), p.material().shininess());
        }
        double weak = f;
        double lambert = Math.max(nl, 0);
        double gloss = shine;
        var m = p.material();
        var s = p.light();
        return IntStream.range(0, 3)
                .mapToDouble(
                        i ->
                                m.emission()[i]
                                        + m.ambient()[i] * (p.globalAmbient()[i] + weak * s.ambient()[i])
                                        + weak * lambert * m.diffuse()[i] * s.diffuse()[i]
                                        + weak * gloss * m.specular()[i] * s.specular()[i])
                .map(i -> i > 1 ? 1 : i)
                .toArray();
    }
}
