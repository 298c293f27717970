package rasterlab.engine.pipeline.triangle;

import java.util.Arrays;
import rasterlab.engine.raster.Raster;

/** A picture and the depth of each of its pixels: 0 at the near plane, 1 at the far one. */
public final class DepthRaster {
    /** The depth where nothing is drawn. */
    public static final float FARTHEST = 1;

    private final Raster raster;
    private final float[] depth;

    /** A picture of transparent black, everything at the far plane. */
    public DepthRaster(int width, int height) {
        raster = new Raster(width, height);
        depth = new float[width * height];
        Arrays.fill(depth, FARTHEST);
    }

    public int width() {
        return raster.width();
    }

    public int height() {
        return raster.height();
    }

    /** The colours, not a copy. */
    public Raster raster() {
        return raster;
    }

    /** The depths, not a copy: cell {@code y * width + x}. */
    public float[] depth() {
        return depth;
    }

    /** Gives a band of rows one colour 0xAARRGGBB at the far plane. */
    void clearRows(int top, int argb) {
        int from = top * width();
        int to = Math.min(top + TriangleScan.ROWS, height()) * width();
        Arrays.fill(raster.argb(), from, to, argb);
        Arrays.fill(depth, from, to, FARTHEST);
    }
}
