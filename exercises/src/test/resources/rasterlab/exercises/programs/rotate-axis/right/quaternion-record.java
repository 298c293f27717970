import rasterlab.contract.*;

public class MyMethod implements AxisRotation {

    record Q(double w, double x, double y, double z) {
        Q times(Q o) {
            return new Q(
                    w * o.w - x * o.x - y * o.y - z * o.z,
                    w * o.x + x * o.w + y * o.z - z * o.y,
                    w * o.y - x * o.z + y * o.w + z * o.x,
                    w * o.z + x * o.y - y * o.x + z * o.w);
        }

        Q c() {
            return new Q(w, -x, -y, -z);
        }
    }

    public void rotate(double[] c, double[] d, double degrees, double[] p) {
        double big = Math.max(Math.abs(d[0]), Math.max(Math.abs(d[1]), Math.abs(d[2])));
        double dx = d[0] / big,
                dy = d[1] / big,
                dz = d[2] / big,
                l = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double h = Math.toRadians(degrees % 720) / 2, s = Math.sin(h) / l;
        Q q = new Q(Math.cos(h), s * dx, s * dy, s * dz);
        for (int i = 0; i < p.length; i += 3) {
            Q r = q.times(new Q(0, p[i] - c[0], p[i + 1] - c[1], p[i + 2] - c[2])).times(q.c());
            p[i] = c[0] + r.x;
            p[i + 1] = c[1] + r.y;
            p[i + 2] = c[2] + r.z;
        }
    }
}
