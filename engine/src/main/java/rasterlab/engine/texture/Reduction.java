package rasterlab.engine.texture;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Makes a texture's levels: each texel is the mean of level 0 over its own area.
 *
 * <p>A row of n texels becomes one of m = max(1, ⌊n/2⌋), then of ⌊m/2⌋ and so on; texel i of m
 * covers [i·n/m, (i + 1)·n/m), with the share of a texel that is cut in two. Every level is made
 * from level 0, so no rounding adds up. Channels are averaged one by one, alpha too, as OpenGL's
 * utility library does.
 */
final class Reduction {
    private static final int CHANNELS = 4;

    private final TextureLevel picture;
    private final Cover columns;
    private final Cover rows;
    private final double[] row;

    private Reduction(TextureLevel picture, int width, int height) {
        this.picture = picture;
        columns = Cover.of(picture.width(), width);
        rows = Cover.of(picture.height(), height);
        row = new double[width * CHANNELS];
    }

    static List<TextureLevel> levels(TextureLevel picture) {
        var levels = new ArrayList<TextureLevel>(List.of(picture));
        int width = picture.width();
        int height = picture.height();
        while (width > 1 || height > 1) {
            width = Math.max(1, width / 2);
            height = Math.max(1, height / 2);
            levels.add(new Reduction(picture, width, height).level());
        }
        return List.copyOf(levels);
    }

    private TextureLevel level() {
        int width = columns.first.length;
        int height = rows.first.length;
        var argb = new int[width * height];
        for (int j = 0; j < height; j++) {
            Arrays.fill(row, 0);
            for (int k = rows.first[j]; k <= rows.last[j]; k++) addRow(k, rows.share(k, j));
            for (int i = 0; i < width; i++) argb[j * width + i] = rounded(i);
        }
        return new TextureLevel(width, height, argb);
    }

    /** Adds row {@code k} of level 0 with that share. */
    private void addRow(int k, double part) {
        for (int i = 0; i < columns.first.length; i++)
            for (int x = columns.first[i]; x <= columns.last[i]; x++) {
                double share = part * columns.share(x, i);
                int texel = picture.texel(x, k);
                row[i * CHANNELS] += share * (texel >>> 24);
                row[i * CHANNELS + 1] += share * (texel >> 16 & 255);
                row[i * CHANNELS + 2] += share * (texel >> 8 & 255);
                row[i * CHANNELS + 3] += share * (texel & 255);
            }
    }

    /**
     * Which of n texels of a line each of m covers, and with what share.
     *
     * @param first the first one that each covers
     * @param last the last one that each covers
     * @param firstShare of the first one in the mean
     * @param lastShare of the last one in the mean
     * @param inner share of every other
     */
    private record Cover(
            int[] first, int[] last, double[] firstShare, double[] lastShare, double inner) {
        static Cover of(int n, int m) {
            var cover =
                    new Cover(new int[m], new int[m], new double[m], new double[m], m / (double) n);
            for (int i = 0; i < m; i++) {
                cover.first[i] = i * n / m;
                cover.last[i] = ((i + 1) * n - 1) / m;
                cover.firstShare[i] = common(cover.first[i], i, n, m);
                cover.lastShare[i] = common(cover.last[i], i, n, m);
            }
            return cover;
        }

        /** The share of texel {@code i} of m that texel {@code x} of n covers. */
        private static double common(int x, int i, int n, int m) {
            int begin = Math.max(i * n, x * m);
            int end = Math.min((i + 1) * n, (x + 1) * m);
            return (end - begin) / (double) n;
        }

        double share(int x, int i) {
            return x == first[i] ? firstShare[i] : x == last[i] ? lastShare[i] : inner;
        }
    }

    private int rounded(int i) {
        int argb = 0;
        for (int c = 0; c < CHANNELS; c++) argb = argb << 8 | (int) (row[i * CHANNELS + c] + 0.5);
        return argb;
    }
}
