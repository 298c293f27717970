import rasterlab.contract.TextureFilter;

public class Bilinear implements TextureFilter {
    @Override
    public int[] colors(int w, int h, int[] argb, double[] f) {
        int[] out = new int[f.length / 6];
        for (int k = 0; k < out.length; k++) {
            double u = f[6 * k] * w - 0.5;
            double v = f[6 * k + 1] * h - 0.5;
            int i = (int) Math.floor(u);
            int j = (int) Math.floor(v);
            double a = u - i;
            double b = v - j;
            int color = 0;
            for (int shift = 24; shift >= 0; shift -= 8) {
                double low = (1 - a) * at(argb, w, h, i, j, shift) + a * at(argb, w, h, i + 1, j, shift);
                double up =
                        (1 - a) * at(argb, w, h, i, j + 1, shift)
                                + a * at(argb, w, h, i + 1, j + 1, shift);
                color |= (int) ((1 - b) * low + b * up + 0.5) << shift;
            }
            out[k] = color;
        }
        return out;
    }

    private static int at(int[] argb, int w, int h, int i, int j, int shift) {
        return argb[(h - 1 - Math.floorMod(j, h)) * w + Math.floorMod(i, w)] >>> shift & 255;
    }
}
