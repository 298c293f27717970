import java.util.Arrays;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonSink;

public class Clip implements PolygonClipper {
    @Override
    public void clip(double[] window, double[] subject, PolygonSink out) {
        double[] w = area(window) < 0 ? back(window) : window;
        boolean turned = area(subject) < 0;
        double[] ring = subject;
        for (int a = 0; a < w.length; a += 2) {
            int b = (a + 2) % w.length;
            ring = cut(ring, w[a], w[a + 1], w[b], w[b + 1]);
        }
        if (ring.length < 6 || Math.abs(area(ring)) <= 1e-12 * area(w)) return;
        out.polygon(turned ? back(ring) : ring);
    }

    private static double[] box(double[] w) {
        double[] b = {w[0], w[1], w[0], w[1]};
        for (int i = 0; i < w.length; i += 2) {
            b[0] = Math.min(b[0], w[i]);
            b[1] = Math.min(b[1], w[i + 1]);
            b[2] = Math.max(b[2], w[i]);
            b[3] = Math.max(b[3], w[i + 1]);
        }
        return new double[] {b[0], b[1], b[2], b[1], b[2], b[3], b[0], b[3]};
    }

    private static double[] back(double[] r) {
        double[] t = new double[r.length];
        for (int i = 0; i < r.length; i += 2) {
            t[i] = r[r.length - 2 - i];
            t[i + 1] = r[r.length - 1 - i];
        }
        return t;
    }

    private static double area(double[] r) {
        double sum = 0;
        for (int i = 0; i < r.length; i += 2) {
            int j = (i + 2) % r.length;
            sum += r[i] * r[j + 1] - r[j] * r[i + 1];
        }
        return sum / 2;
    }

    private static double[] cut(double[] r, double ax, double ay, double bx, double by) {
        double[] left = new double[2 * r.length];
        int n = 0;
        for (int i = 0; i < r.length; i += 2) {
            int j = (i + 2) % r.length;
            double d = (bx - ax) * (r[i + 1] - ay) - (by - ay) * (r[i] - ax);
            double e = (bx - ax) * (r[j + 1] - ay) - (by - ay) * (r[j] - ax);
            if (d >= 0) {
                left[n++] = r[i];
                left[n++] = r[i + 1];
            }
            if (d * e < 0) {
                left[n++] = r[i] + d / (d - e) * (r[j] - r[i]);
                left[n++] = r[i + 1] + d / (d - e) * (r[j + 1] - r[i + 1]);
            }
        }
        return Arrays.copyOf(left, n);
    }
}
