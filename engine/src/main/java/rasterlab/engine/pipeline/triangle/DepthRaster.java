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

    private DepthRaster(Raster raster, float[] depth) {
        this.raster = raster;
        this.depth = depth;
    }

    /**
     * These depths, not a copy, for the pixels of another picture.
     *
     * @throws IllegalArgumentException if its size is another
     */
    public DepthRaster of(Raster picture) {
        if (picture.width() != width() || picture.height() != height())
            throw new IllegalArgumentException(
                    "picture must be of %d×%d pixels, got %d×%d"
                            .formatted(width(), height(), picture.width(), picture.height()));
        return new DepthRaster(picture, depth);
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
}
