import rasterlab.contract.SpaceSegmentSink;
import rasterlab.contract.VolumeClipper;

/** Brings both ends to the picture first and clips by the box there. */
public class Divided implements VolumeClipper {
    @Override
    public void clip(double zmin, double x0, double y0, double z0, double x1, double y1, double z1, SpaceSegmentSink out) {
        double[] a = divided(zmin, x0, y0, z0);
        double[] b = divided(zmin, x1, y1, z1);
        double[] least = {-1, -1, 0};
        double in = 0;
        double on = 1;
        for (int i = 0; i < 3; i++) {
            double d = b[i] - a[i];
            if (d == 0) {
                if (a[i] < least[i] || a[i] > 1) return;
                continue;
            }
            double s = (least[i] - a[i]) / d;
            double e = (1 - a[i]) / d;
            in = Math.max(in, Math.min(s, e));
            on = Math.min(on, Math.max(s, e));
        }
        if (in > on) return;
        double[] p = in == 0 ? new double[] {x0, y0, z0} : back(zmin, a, b, in);
        double[] q = on == 1 ? new double[] {x1, y1, z1} : back(zmin, a, b, on);
        out.segment(p[0], p[1], p[2], q[0], q[1], q[2]);
    }

    private static double[] divided(double zmin, double x, double y, double z) {
        return new double[] {x / z, y / z, (z - zmin) / ((1 - zmin) * z)};
    }

    private static double[] back(double zmin, double[] a, double[] b, double t) {
        double x = a[0] + t * (b[0] - a[0]);
        double y = a[1] + t * (b[1] - a[1]);
        double z = zmin / (1 - (1 - zmin) * (a[2] + t * (b[2] - a[2])));
        return new double[] {x * z, y * z, z};
    }
}
