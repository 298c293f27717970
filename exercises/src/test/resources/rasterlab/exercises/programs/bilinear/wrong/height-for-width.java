import java.util.stream.IntStream;
import rasterlab.contract.TextureFilter;

public class Packed implements TextureFilter {
    record Corner(int i, int j, double weight) {}

    @Override
    public int[] colors(int w, int h, int[] argb, double[] f) {
        return IntStream.range(0, f.length / 6)
                .map(k -> color(w, h, argb, f[6 * k] - Math.floor(f[6 * k]), wrapped(f[6 * k + 1])))
                .toArray();
    }

    private static double wrapped(double t) {
        return ((t % 1) + 1) % 1;
    }

    private static int color(int w, int h, int[] argb, double s, double t) {
        double u = s * w - 0.5;
        double v = t * h - 0.5;
        int i = (int) Math.floor(u);
        int j = (int) Math.floor(v);
        double a = u - i;
        double b = v - j;
        Corner[] four = {
            new Corner(i, j, (1 - a) * (1 - b)),
            new Corner(i + 1, j, a * (1 - b)),
            new Corner(i, j + 1, (1 - a) * b),
            new Corner(i + 1, j + 1, a * b)
        };
        double[] sum = new double[4];
        for (Corner one : four) {
            int texel = argb[(one.j() + h) % h * h + (one.i() + w) % w];
            for (int c = 0; c < 4; c++) sum[c] += one.weight() * (texel >>> 8 * c & 0xFF);
        }
        int packed = 0;
        for (int c = 3; c >= 0; c--) packed = packed << 8 | (int) Math.round(sum[c]);
        return packed;
    }
}
