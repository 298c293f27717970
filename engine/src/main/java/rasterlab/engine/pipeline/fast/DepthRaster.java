package rasterlab.engine.pipeline.fast;

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

    /**
     * A picture with depths that are there already, neither of them copied.
     *
     * @param depth one for each cell
     * @throws IllegalArgumentException if there are more or fewer
     */
    public DepthRaster(Raster raster, float[] depth) {
        if (depth.length != raster.argb().length)
            throw new IllegalArgumentException(
                    "depth must hold %d numbers for %d×%d pixels, got %d"
                            .formatted(
                                    raster.argb().length,
                                    raster.width(),
                                    raster.height(),
                                    depth.length));
        this.raster = raster;
        this.depth = depth;
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
