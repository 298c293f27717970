import rasterlab.contract.*;

/** Region codes, one end moved at a time. */
public class Codes implements VolumeClipper {
    @Override
    public void clip(double zmin, double x0, double y0, double z0, double x1, double y1, double z1, SpaceSegmentSink out) {
        double[] a = {x0, y0, z0};
        double[] b = {x1, y1, z1};
        while (true) {
            int ca = code(a, zmin);
            int cb = code(b, zmin);
            if ((ca & cb) != 0) return;
            if ((ca | cb) == 0) break;
            double[] p = ca != 0 ? a : b;
            double[] q = ca != 0 ? b : a;
            int plane = Integer.numberOfTrailingZeros(ca != 0 ? ca : cb);
            double dp = value(plane, p, zmin);
            double dq = value(plane, q, zmin);
            double t = dp / (dp - dq);
            double x = p[0] + t * (q[0] - p[0]);
            double y = p[1] + t * (q[1] - p[1]);
            double z = p[2] + t * (q[2] - p[2]);
            if (plane == 0) x = z;
            if (plane == 1) x = -z;
            if (plane == 2) y = z;
            if (plane == 3) y = -z;
            if (plane == 4) z = zmin;
            if (plane == 5) z = 1;
            p[0] = x;
            p[1] = y;
            p[2] = z;
        }
        out.segment(a[0], a[1], a[2], b[0], b[1], b[2]);
    }

    private int code(double[] p, double zmin) {
        int code = 0;
        for (int plane = 0; plane < 6; plane++) if (value(plane, p, zmin) < 0) code |= 1 << plane;
        return code;
    }

    private double value(int plane, double[] p, double zmin) {
        return switch (plane) {
            case 0 -> p[2] - p[0];
            case 1 -> p[2] + p[0];
            case 2 -> p[2] - p[1];
            case 3 -> p[2] + p[1];
            case 4 -> p[2] - zmin;
            default -> 1 - p[2];
        };
    }
}
