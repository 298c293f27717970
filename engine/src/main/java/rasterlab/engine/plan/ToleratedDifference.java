package rasterlab.engine.plan;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;

/**
 * How far two pictures are apart, where things may be moved by some pixels.
 *
 * <p>What a pixel shows may come from up to so many pixels away. It is as it should be where each
 * channel lies between the least and the most that the other picture has around such places: in the
 * pixels whose centres are corners of a unit cell that is nearer than the tolerance.
 *
 * @param levels how far a channel is beyond that, at most
 * @param wrong pixels that are beyond by more than the tolerance's levels
 * @param pixels of the picture
 */
public record ToleratedDifference(double levels, long wrong, long pixels) {

    /** Compares both ways, so that what is missing counts as what is too much. */
    public static ToleratedDifference of(Raster full, Raster least, Tolerance tolerance) {
        int[] offsets = offsets(tolerance.pixels());
        long wrong = 0;
        int most = 0;
        int width = full.width();
        int height = full.height();
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                int a = full.argb()[y * width + x];
                int b = least.argb()[y * width + x];
                if (a == b) continue;
                int off =
                        Math.max(
                                beyond(least, x, y, full, offsets),
                                beyond(full, x, y, least, offsets));
                most = Math.max(most, off);
                if (off > tolerance.levels()) wrong++;
            }
        return new ToleratedDifference(most, wrong, (long) width * height);
    }

    /** Wrong pixels as a share of all. */
    public double share() {
        return (double) wrong / pixels;
    }

    public boolean within(Tolerance tolerance) {
        return share() <= tolerance.share();
    }

    /** Pairs dx, dy, the pixel itself first. */
    static int[] offsets(double pixels) {
        int reach = (int) Math.ceil(pixels) + 1;
        int[] pairs = new int[2 * (2 * reach + 1) * (2 * reach + 1)];
        int at = 2;
        for (int dy = -reach; dy <= reach; dy++)
            for (int dx = -reach; dx <= reach; dx++) {
                int right = Math.max(Math.abs(dx) - 1, 0);
                int down = Math.max(Math.abs(dy) - 1, 0);
                if (dx == 0 && dy == 0 || right * right + down * down >= pixels * pixels) continue;
                pairs[at++] = dx;
                pairs[at++] = dy;
            }
        return Arrays.copyOf(pairs, at);
    }

    /** How far a pixel is beyond what another picture has around it, in levels. */
    private static int beyond(Raster of, int x, int y, Raster around, int[] offsets) {
        int argb = of.argb()[y * of.width() + x];
        int most = 0;
        for (int shift = 0; shift < 32; shift += 8) {
            int level = argb >>> shift & 255;
            int low = 255;
            int high = 0;
            for (int i = 0; i < offsets.length && (level < low || level > high); i += 2) {
                int px = x + offsets[i];
                int py = y + offsets[i + 1];
                if (!around.contains(px, py)) continue;
                int there = around.argb()[py * around.width() + px] >>> shift & 255;
                low = Math.min(low, there);
                high = Math.max(high, there);
            }
            most = Math.max(most, Math.max(low - level, level - high));
        }
        return most;
    }
}
