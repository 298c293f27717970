package rasterlab.engine.pipeline.paint;

/** The light on a face before anything is laid on it. Several threads may use one at once. */
interface SurfaceColor {
    /** Sets the colours of a row from its weights. */
    void light(int face, PixelRow row);
}
