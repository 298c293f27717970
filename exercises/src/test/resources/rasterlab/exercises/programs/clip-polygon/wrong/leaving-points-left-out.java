import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements PolygonClipper {

    public void clip(double[] window, double[] subject, PolygonSink out) {
        List<double[]> w = points(window), poly = points(subject);
        double wa = area(w);
        if (wa < 0) Collections.reverse(w);
        if (area(poly) < 0) Collections.reverse(poly);
        for (int i = 0; i < w.size(); i++) {
            double[] a = w.get(i), b = w.get((i + 1) % w.size());
            List<double[]> next = new ArrayList<>();
            for (int k = 0; k < poly.size(); k++) {
                double[] p = poly.get(k), q = poly.get((k + 1) % poly.size());
                double dp = d(a, b, p), dq = d(a, b, q);
                if (dp >= 0) next.add(p);
                if (dp < 0 && dq > 0) {
                    double t = dp / (dp - dq);
                    next.add(new double[] {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
                }
            }
            poly = next;
        }
        if (poly.size() < 3 || Math.abs(area(poly)) <= 1e-12 * Math.abs(wa)) return;
        out.polygon(poly.stream().flatMapToDouble(Arrays::stream).toArray());
    }

    static double d(double[] a, double[] b, double[] p) {
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    }

    static List<double[]> points(double[] v) {
        List<double[]> r = new ArrayList<>();
        for (int i = 0; i < v.length; i += 2) r.add(new double[] {v[i], v[i + 1]});
        return r;
    }

    static double area(List<double[]> v) {
        double s = 0;
        if (v.isEmpty()) return 0;
        double[] o = v.get(0);
        for (int i = 0; i < v.size(); i++) {
            double[] p = v.get(i), q = v.get((i + 1) % v.size());
            s += (p[0] - o[0]) * (q[1] - o[1]) - (q[0] - o[0]) * (p[1] - o[1]);
        }
        return s / 2;
    }
}
