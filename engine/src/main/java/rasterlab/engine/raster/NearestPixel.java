package rasterlab.engine.raster;

/**
 * Finds how far the nearest pixel of a recording is, in whole pixels: max(|Δx|, |Δy|) (Chebyshev).
 *
 * <p>A binary tree of bounding boxes over runs of writes: lines and outlines are written in order
 * of place, so the boxes are small and a question looks into few of them. Any order gives the same
 * answer, only slower.
 */
public final class NearestPixel {
    private static final int RUN = 8;

    private final PixelRecording pixels;
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
        this.pixels = pixels;
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

    private void bound(int node) {
        minX[node] = minY[node] = Integer.MAX_VALUE;
        maxX[node] = maxY[node] = Integer.MIN_VALUE;
        if (node < leaves) {
            include(node, minX[2 * node], minY[2 * node], maxX[2 * node], maxY[2 * node]);
            int right = 2 * node + 1;
            include(node, minX[right], minY[right], maxX[right], maxY[right]);
        } else {
            for (int i = start(node); i < end(node); i++)
                include(node, pixels.x(i), pixels.y(i), pixels.x(i), pixels.y(i));
        }
    }

    private void include(int node, int x0, int y0, int x1, int y1) {
        minX[node] = Math.min(minX[node], x0);
        minY[node] = Math.min(minY[node], y0);
        maxX[node] = Math.max(maxX[node], x1);
        maxY[node] = Math.max(maxY[node], y1);
    }

    private int start(int leaf) {
        return Math.min((leaf - leaves) * RUN, pixels.size());
    }

    private int end(int leaf) {
        return Math.min((leaf - leaves + 1) * RUN, pixels.size());
    }

    private long nearest(int node, int x, int y, long best) {
        if (toBox(node, x, y) >= best) return best;
        if (node >= leaves) {
            for (int i = start(node); i < end(node); i++)
                best = Math.min(best, chebyshev((long) x - pixels.x(i), (long) y - pixels.y(i)));
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
