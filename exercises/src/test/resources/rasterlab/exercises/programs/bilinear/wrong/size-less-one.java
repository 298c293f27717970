import rasterlab.contract.*;

public class MyMethod implements TextureFilter {

    public int[] colors(int w, int h, int[] t, double[] fp) {
        int[] r = new int[fp.length / 6];
        for (int p = 0; p < r.length; p++) {
            double u = fp[6 * p] * (w - 1), v = fp[6 * p + 1] * (h - 1);
            double fi = Math.floor(u), fj = Math.floor(v), a = u - fi, b = v - fj;
            int i = (int) (fi - w * Math.floor(fi / w)),
                    j = (int) (fj - h * Math.floor(fj / h)),
                    i1 = (i + 1) % w,
                    j1 = (j + 1) % h;
            int c = 0;
            for (int s = 24; s >= 0; s -= 8) {
                double x =
                        (1 - b) * ((1 - a) * ch(t[j * w + i], s) + a * ch(t[j * w + i1], s))
                                + b * ((1 - a) * ch(t[j1 * w + i], s) + a * ch(t[j1 * w + i1], s));
                c |= (int) Math.round(x) << s;
            }
            r[p] = c;
        }
        return r;
    }

    static int ch(int c, int s) {
        return c >>> s & 255;
    }
}
