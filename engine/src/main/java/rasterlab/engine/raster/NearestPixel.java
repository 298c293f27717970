package rasterlab.engine.raster;

import java.util.Arrays;
import java.util.stream.IntStream;

/**
 * Finds how far the nearest pixel of a recording is, in whole pixels: max(|Δx|, |Δy|) (Chebyshev).
 *
 * <p>A binary tree of bounding boxes over runs of pixels in Z-order, that is sorted by the bits of
 * x and y in turn, so that the boxes are small in whatever order the pixels were written and a
 * question looks into few of them.
 *
 * <p>Source: G. M. Morton, A computer oriented geodetic data base, IBM, 1966.
 */
public final class NearestPixel {
    private static final int RUN = 8;

    private final int[] xs;
    private final int[] ys;
    private final int leaves;
    private final int[] minX;
    private final int[] minY;
    private final int[] maxX;
    private final int[] maxY;

    /**
     * @param pixels at least one
     */
    public NearestPixel(PixelRecording pixels) {
        if (pixels.size() == 0)
            throw new IllegalArgumentException("needs at least 1 pixel, got an empty recording");
        long[] sorted =
                IntStream.range(0, pixels.size())
                        .mapToLong(i -> zOrder(pixels.x(i), pixels.y(i)))
                        .sorted()
                        .toArray();
        xs = Arrays.stream(sorted).mapToInt(NearestPixel::everySecondBit).toArray();
        ys = Arrays.stream(sorted).mapToInt(z -> everySecondBit(z >>> 1)).toArray();
        for (int i = 0; i < xs.length; i++) xs[i] ^= Integer.MIN_VALUE;
        int runs = (pixels.size() - 1) / RUN + 1;
        leaves = Math.max(1, Integer.highestOneBit(2 * runs - 1));
        minX = new int[2 * leaves];
        minY = new int[2 * leaves];
        maxX = new int[2 * leaves];
        maxY = new int[2 * leaves];
        for (int node = 2 * leaves - 1; node >= 1; node--) bound(node);
    }

    /** Distance from (x, y) to the nearest pixel: 0 if that one was written, at most 2³² − 1. */
    public long distance(int x, int y) {
        return nearest(1, x, y, Long.MAX_VALUE);
    }

    /** The bits of y and x in turn, x's sign bit flipped: sorts as one number. */
    private static long zOrder(int x, int y) {
        return spread(y) << 1 | spread(x ^ Integer.MIN_VALUE);
    }

    /** Each of the 32 bits two places from the next. */
    private static long spread(int value) {
        long bits = value & 0xFFFF_FFFFL;
        bits = (bits | bits << 16) & 0x0000_FFFF_0000_FFFFL;
        bits = (bits | bits << 8) & 0x00FF_00FF_00FF_00FFL;
        bits = (bits | bits << 4) & 0x0F0F_0F0F_0F0F_0F0FL;
        bits = (bits | bits << 2) & 0x3333_3333_3333_3333L;
        return (bits | bits << 1) & 0x5555_5555_5555_5555L;
    }

    private static int everySecondBit(long spread) {
        long bits = spread & 0x5555_5555_5555_5555L;
        bits = (bits | bits >>> 1) & 0x3333_3333_3333_3333L;
        bits = (bits | bits >>> 2) & 0x0F0F_0F0F_0F0F_0F0FL;
        bits = (bits | bits >>> 4) & 0x00FF_00FF_00FF_00FFL;
        bits = (bits | bits >>> 8) & 0x0000_FFFF_0000_FFFFL;
        return (int) (bits | bits >>> 16);
    }

    private void bound(int node) {
        minX[node] = minY[node] = Integer.MAX_VALUE;
        maxX[node] = maxY[node] = Integer.MIN_VALUE;
        if (node < leaves) {
            include(node, minX[2 * node], minY[2 * node], maxX[2 * node], maxY[2 * node]);
            int right = 2 * node + 1;
            include(node, minX[right], minY[right], maxX[right], maxY[right]);
        } else {
            for (int i = start(node); i < end(node); i++) include(node, xs[i], ys[i], xs[i], ys[i]);
        }
    }

    private void include(int node, int x0, int y0, int x1, int y1) {
        minX[node] = Math.min(minX[node], x0);
        minY[node] = Math.min(minY[node], y0);
        maxX[node] = Math.max(maxX[node], x1);
        maxY[node] = Math.max(maxY[node], y1);
    }

    private int start(int leaf) {
        return Math.min((leaf - leaves) * RUN, xs.length);
    }

    private int end(int leaf) {
        return Math.min((leaf - leaves + 1) * RUN, xs.length);
    }

    private long nearest(int node, int x, int y, long best) {
        if (toBox(node, x, y) >= best) return best;
        if (node >= leaves) {
            for (int i = start(node); i < end(node); i++)
                best = Math.min(best, chebyshev((long) x - xs[i], (long) y - ys[i]));
            return best;
        }
        int near = 2 * node;
        int far = near + 1;
        if (toBox(far, x, y) < toBox(near, x, y)) {
            near = far;
            far = 2 * node;
        }
        return nearest(far, x, y, nearest(near, x, y, best));
    }

    private long toBox(int node, int x, int y) {
        if (minX[node] > maxX[node]) return Long.MAX_VALUE; // no pixels in this run
        long beside = Math.max((long) minX[node] - x, (long) x - maxX[node]);
        long above = Math.max((long) minY[node] - y, (long) y - maxY[node]);
        return Math.max(0, Math.max(beside, above));
    }

    private static long chebyshev(long dx, long dy) {
        return Math.max(Math.abs(dx), Math.abs(dy));
    }
}
