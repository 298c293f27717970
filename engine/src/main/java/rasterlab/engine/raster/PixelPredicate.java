package rasterlab.engine.raster;

/** A yes or no about a pixel. */
@FunctionalInterface
public interface PixelPredicate {
    boolean test(int x, int y);
}
