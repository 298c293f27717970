package rasterlab.engine.raster;

/**
 * What a method plotted, in order.
 *
 * @param cut whether these are only its first pixels, because it was stopped or no more were kept
 */
public record Plotted(PixelRecording pixels, boolean cut) {
    /** All that was plotted. */
    public static Plotted whole(PixelRecording pixels) {
        return new Plotted(pixels, false);
    }
}
