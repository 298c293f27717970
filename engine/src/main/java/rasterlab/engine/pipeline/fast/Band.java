package rasterlab.engine.pipeline.fast;

import java.util.Arrays;

/**
 * The rows that a thread draws now, and the depths of their pixels: the picture's where it keeps
 * them; else the thread's own, the same for each band, which hardly leave its core's cache.
 */
final class Band {
    /** The colours of the whole picture, 0xAARRGGBB. */
    int[] argb;

    /** Depth of a cell of the picture: {@code depth[cell - depthStart]}. */
    float[] depth;

    int depthStart;

    /** The whole picture's sides, in pixels. */
    int width;

    int height;

    /** The first row. */
    int top;

    private float[] own = {};

    void begin(FrameState frame, int number) {
        argb = frame.picture.argb();
        width = frame.picture.width();
        height = frame.picture.height();
        top = number * TriangleScan.ROWS;
        int first = top * width;
        int end = bottom() * width;
        if (frame.depth.length > 0) {
            depth = frame.depth;
            depthStart = 0;
        } else {
            if (own.length < TriangleScan.ROWS * width) own = new float[TriangleScan.ROWS * width];
            depth = own;
            depthStart = first;
        }
        if (!frame.clears) return;
        Arrays.fill(argb, first, end, frame.background);
        Arrays.fill(depth, first - depthStart, end - depthStart, DepthRaster.FARTHEST);
    }

    /** Drops the picture. */
    void end() {
        argb = null;
        depth = own;
    }

    /** The row after the last one. */
    int bottom() {
        return Math.min(top + TriangleScan.ROWS, height);
    }
}
