package rasterlab.engine.raster;

/**
 * The pixels that a method plotted, in order.
 *
 * @param cut whether these are only its first pixels, because it was stopped or no more were kept
 */
public record Plotted(PixelRecording pixels, boolean cut) {}
