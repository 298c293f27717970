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
    private final int width;
    private final int height;
    private final double[] row;

    private Reduction(TextureLevel picture, int width, int height) {
        this.picture = picture;
        this.width = width;
        this.height = height;
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
        var argb = new int[width * height];
        for (int j = 0; j < height; j++) {
            Arrays.fill(row, 0);
            for (int k = first(j, picture.height(), height);
                    k <= last(j, picture.height(), height);
                    k++) addRow(k, share(k, j, picture.height(), height));
            for (int i = 0; i < width; i++) argb[j * width + i] = rounded(i);
        }
        return new TextureLevel(width, height, argb);
    }

    /** Adds row {@code k} of level 0 with that share. */
    private void addRow(int k, double part) {
        for (int i = 0; i < width; i++)
            for (int x = first(i, picture.width(), width);
                    x <= last(i, picture.width(), width);
                    x++) {
                double share = part * share(x, i, picture.width(), width);
                int texel = picture.texel(x, k);
                row[i * CHANNELS] += share * (texel >>> 24);
                row[i * CHANNELS + 1] += share * (texel >> 16 & 255);
                row[i * CHANNELS + 2] += share * (texel >> 8 & 255);
                row[i * CHANNELS + 3] += share * (texel & 255);
            }
    }

    /** The first of {@code from} texels that texel {@code i} of {@code to} covers. */
    private static int first(int i, int from, int to) {
        return i * from / to;
    }

    private static int last(int i, int from, int to) {
        return ((i + 1) * from - 1) / to;
    }

    /** What share of texel {@code i} of {@code to} is texel {@code x} of {@code from}. */
    private static double share(int x, int i, int from, int to) {
        int begin = Math.max(i * from, x * to);
        int end = Math.min((i + 1) * from, (x + 1) * to);
        return (end - begin) / (double) from;
    }

    private int rounded(int i) {
        int argb = 0;
        for (int c = 0; c < CHANNELS; c++) argb = argb << 8 | (int) (row[i * CHANNELS + c] + 0.5);
        return argb;
    }
}
