import java.util.ArrayList;
import rasterlab.contract.TextureFilter;

public class Pyramid implements TextureFilter {
    private record Picture(int w, int h, int[] texels) {
        int channel(int i, int j, int c) {
            return texels[Math.floorMod(j, h) * w + Math.floorMod(i, w)] >> c & 255;
        }

        Picture next() {
            int nw = w == 1 ? 1 : w / 2;
            int nh = h == 1 ? 1 : h / 2;
            int[] made = new int[nw * nh];
            for (int j = 0; j < nh; j++)
                for (int i = 0; i < nw; i++)
                    for (int c = 0; c < 32; c += 8) {
                        int sum = 0;
                        int n = 0;
                        for (int y = j * h / nh; y < (j + 1) * h / nh; y++)
                            for (int x = i * w / nw; x < (i + 1) * w / nw; x++, n++)
                                sum += channel(x, y, c);
                        made[j * nw + i] |= (sum + n / 2) / n << c;
                    }
            return new Picture(nw, nh, made);
        }

        double at(double s, double t, int c) {
            double u = s * w - .5;
            double v = t * h - .5;
            int i = (int) Math.floor(u);
            int j = (int) Math.floor(v);
            double low = lerp(channel(i, j, c), channel(i + 1, j, c), u - i);
            double up = lerp(channel(i, j + 1, c), channel(i + 1, j + 1, c), u - i);
            return lerp(low, up, v - j);
        }
    }

    static double lerp(double a, double b, double f) {
        return a + (b - a) * f;
    }

    @Override
    public int[] colors(int w, int h, int[] argb, double[] f) {
        var levels = new ArrayList<Picture>();
        for (Picture p = new Picture(w, h, argb); ; p = p.next()) {
            levels.add(p);
            if (p.w() == 1 && p.h() == 1) break;
        }
        int last = levels.size() - 1;
        int[] out = new int[f.length / 6];
        for (int k = 0, at = 0; k < out.length; k++, at += 6) {
            double x = w * w * f[at + 2] * f[at + 2] + h * h * f[at + 3] * f[at + 3];
            double y = w * w * f[at + 4] * f[at + 4] + h * h * f[at + 5] * f[at + 5];
            double lambda = Math.log10(Math.max(x, y)) / Math.log10(4) + 1;
            lambda = lambda > last ? last : lambda < 0 ? 0 : lambda;
            int fine = (int) lambda;
            Picture a = levels.get(fine);
            Picture b = levels.get(Math.min(last, fine + 1));
            for (int c = 0; c < 32; c += 8)
                out[k] |=
                        (int) Math.round(
                                        lerp(
                                                a.at(f[at], f[at + 1], c),
                                                b.at(f[at], f[at + 1], c),
                                                lambda - fine))
                                << c;
        }
        return out;
    }
}
