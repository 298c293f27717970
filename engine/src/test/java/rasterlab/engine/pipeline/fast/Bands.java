package rasterlab.engine.pipeline.fast;

/** A band of a picture that keeps its depths. */
final class Bands {
    private Bands() {}

    /**
     * @param top its first row
     */
    static Band of(DepthRaster out, int top) {
        var frame = new FrameState();
        frame.picture = out.raster();
        frame.depth = out.depth();
        var band = new Band();
        band.begin(frame, top / TriangleScan.ROWS);
        return band;
    }
}
