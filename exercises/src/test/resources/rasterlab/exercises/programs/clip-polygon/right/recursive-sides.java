import rasterlab.contract.*;

import java.util.stream.*;

public class MyMethod implements PolygonClipper {

    interface Next {
        void take(double x, double y);
    }

    public void clip(double[] w, double[] s, PolygonSink out) {
        double wa = area(w);
        double[] win = wa < 0 ? reverse(w) : w, sub = area(s) < 0 ? reverse(s) : s;
        double[] r = stage(win, 0, sub);
        if (r.length >= 6 && area(r) > 1e-12 * Math.abs(wa)) out.polygon(r);
    }

    static double[] stage(double[] w, int i, double[] v) {
        if (i == w.length || v.length == 0) return v;
        int j = (i + 2) % w.length;
        DoubleStream.Builder b = DoubleStream.builder();
        int n = v.length;
        for (int k = 0; k < n; k += 2) {
            int m = (k + 2) % n;
            double d0 = d(w, i, j, v[k], v[k + 1]), d1 = d(w, i, j, v[m], v[m + 1]);
            if (d0 < 0 && d1 > 0 || d0 > 0 && d1 < 0) {
                double t = d0 / (d0 - d1);
                if (d0 > 0) {
                    b.add(v[k]).add(v[k + 1]);
                }
                b.add(v[k] + t * (v[m] - v[k])).add(v[k + 1] + t * (v[m + 1] - v[k + 1]));
            } else if (d0 >= 0) b.add(v[k]).add(v[k + 1]);
        }
        return stage(w, i + 2, b.build().toArray());
    }

    static double d(double[] w, int i, int j, double x, double y) {
        return (w[j] - w[i]) * (y - w[i + 1]) - (w[j + 1] - w[i + 1]) * (x - w[i]);
    }

    static double area(double[] v) {
        double s = 0;
        for (int i = 2; i + 3 < v.length; i += 2)
            s += (v[i] - v[0]) * (v[i + 3] - v[1]) - (v[i + 2] - v[0]) * (v[i + 1] - v[1]);
        return s / 2;
    }

    static double[] reverse(double[] v) {
        double[] r = new double[v.length];
        for (int i = 0; i < v.length; i += 2) {
            r[v.length - 2 - i] = v[i];
            r[v.length - 1 - i] = v[i + 1];
        }
        return r;
    }
}
