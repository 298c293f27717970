import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.TextureFilter;

/** Makes the levels, then mixes four texels in each of the two levels around λ. */
public class Model implements TextureFilter {
    /** Channels of texels row by row, the bottom row first. */
    record Level(int width, int height, double[] channels) {
        static Level of(int width, int height, int[] argb) {
            double[] channels = new double[4 * argb.length];
            for (int k = 0; k < channels.length; k++)
                channels[k] = argb[k / 4] >>> 24 - 8 * (k % 4) & 255;
            return new Level(width, height, channels);
        }

        double at(int i, int j, int channel) {
            return channels[4 * (j % height * width + i % width) + channel];
        }

        Level halved() {
            int w = Math.max(1, width / 2);
            int h = Math.max(1, height / 2);
            double[] means = new double[4 * w * h];
            int right = width > 1 ? 2 : 1;
            int up = height > 1 ? 2 : 1;
            for (int k = 0; k < means.length; k++) {
                int i = k / 4 % w * right;
                int j = k / 4 / w * up;
                int c = k % 4;
                means[k] =
                        (at(i, j, c)
                                        + at(i + right - 1, j, c)
                                        + at(i, j + up - 1, c)
                                        + at(i + right - 1, j + up - 1, c))
                                / 4;
            }
            return new Level(w, h, means);
        }

        double linear(double s, double t, int channel) {
            double u = s * width - 0.5;
            double v = t * height - 0.5;
            double a = u - Math.floor(u);
            double b = v - Math.floor(v);
            int i = Math.floorMod((long) Math.floor(u), width);
            int j = Math.floorMod((long) Math.floor(v), height);
            return (1 - b) * ((1 - a) * at(i, j, channel) + a * at(i + 1, j, channel))
                    + b * ((1 - a) * at(i, j + 1, channel) + a * at(i + 1, j + 1, channel));
        }
    }

    @Override
    public int[] colors(int width, int height, int[] argb, double[] footprints) {
        List<Level> levels = new ArrayList<>(List.of(Level.of(width, height, argb)));
        while (levels.get(levels.size() - 1).channels().length > 4)
            levels.add(levels.get(levels.size() - 1).halved());
        int[] colors = new int[footprints.length / 6];
        for (int k = 0; k < colors.length; k++) {
            double[] f = java.util.Arrays.copyOfRange(footprints, 6 * k, 6 * k + 6);
            double right = Math.hypot(f[2] * width, f[3] * height);
            double down = Math.hypot(f[4] * width, f[5] * height);
            double lambda = Math.log(Math.max(right, down)) / Math.log(2);
            double level = Math.max(0, Math.min(levels.size() - 1, lambda));
            int finer = (int) level;
            int coarser = Math.min(finer + 1, levels.size() - 1);
            double share = level - finer;
            for (int c = 0; c < 4; c++) {
                double fine = levels.get(finer).linear(f[0], f[1], c);
                double coarse = levels.get(coarser).linear(f[0], f[1], c);
                colors[k] = colors[k] << 8 | (int) ((1 - share) * fine + share * coarse + 0.5);
            }
        }
        return colors;
    }
}
