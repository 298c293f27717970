import rasterlab.contract.*;

import java.util.*;

public class MyMethod implements TextureFilter {

    record Level(int w, int h, double[] v) {}

    public int[] colors(int w, int h, int[] t, double[] fp) {
        int[] r = new int[fp.length / 6];
        List<Level>[] lv = new List[4];
        for (int c = 0; c < 4; c++) {
            double[] v = new double[w * h];
            for (int i = 0; i < v.length; i++) v[i] = t[i] >>> 8 * c & 255;
            lv[c] = levels(new Level(w, h, v));
        }
        for (int p = 0; p < r.length; p++) {
            double s = fp[6 * p],
                    q = fp[6 * p + 1],
                    ax = w * fp[6 * p + 2],
                    ay = h * fp[6 * p + 3],
                    bx = w * fp[6 * p + 4],
                    by = h * fp[6 * p + 5];
            double rho = Math.max(Math.hypot(ax, ay), Math.hypot(bx, by)),
                    la = Math.log(rho) / Math.log(2);
            for (int c = 0; c < 4; c++) {
                List<Level> l = lv[c];
                int last = l.size() - 1;
                double x;
                if (la <= 0) x = look(l.get(0), s, q);
                else if (la >= last) x = l.get(last).v[0];
                else {
                    int k = (int) Math.floor(la);
                    double f = 0;
                    x = (1 - f) * look(l.get(k), s, q) + f * look(l.get(k + 1), s, q);
                }
                r[p] |= (int) Math.round(x) << 8 * c;
            }
        }
        return r;
    }

    static List<Level> levels(Level a) {
        List<Level> l = new ArrayList<>(List.of(a));
        while (a.w > 1 || a.h > 1) {
            int W = Math.max(1, a.w / 2), H = Math.max(1, a.h / 2);
            double[] v = new double[W * H];
            for (int j = 0; j < H; j++)
                for (int i = 0; i < W; i++) {
                    int i0 = a.w > 1 ? 2 * i : 0,
                            i1 = a.w > 1 ? 2 * i + 1 : 0,
                            j0 = a.h > 1 ? 2 * j : 0,
                            j1 = a.h > 1 ? 2 * j + 1 : 0;
                    v[j * W + i] =
                            (a.v[j0 * a.w + i0]
                                            + a.v[j0 * a.w + i1]
                                            + a.v[j1 * a.w + i0]
                                            + a.v[j1 * a.w + i1])
                                    / 4;
                }
            a = new Level(W, H, v);
            l.add(a);
        }
        return l;
    }

    static double look(Level l, double s, double t) {
        double u = s * l.w - 0.5,
                v = t * l.h - 0.5,
                fi = Math.floor(u),
                fj = Math.floor(v),
                a = u - fi,
                b = v - fj;
        int i = (int) (fi - l.w * Math.floor(fi / l.w)),
                j = (int) (fj - l.h * Math.floor(fj / l.h)),
                i1 = (i + 1) % l.w,
                j1 = (j + 1) % l.h;
        return (1 - b) * ((1 - a) * l.v[j * l.w + i] + a * l.v[j * l.w + i1])
                + b * ((1 - a) * l.v[j1 * l.w + i] + a * l.v[j1 * l.w + i1]);
    }
}
