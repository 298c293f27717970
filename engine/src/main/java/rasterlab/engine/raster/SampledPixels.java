package rasterlab.engine.raster;

import rasterlab.contract.Pixels;
import rasterlab.engine.study.LimitReached;

/**
 * Keeps a part of the pixels of a figure that has too many to keep, chosen by their places, so that
 * it does not matter in which order they come.
 */
public final class SampledPixels implements Pixels {
    private final PixelPredicate kept;
    private final long most;
    private final PixelRecording recording;
    private long count;

    /**
     * @param most the most pixels to accept, kept or not, before the writer is stopped
     * @param limit the most to keep
     */
    public SampledPixels(PixelPredicate kept, long most, int limit) {
        this.kept = kept;
        this.most = most;
        recording = new PixelRecording(limit);
    }

    @Override
    public void plot(int x, int y) {
        if (count++ == most)
            throw new LimitReached((int) Math.min(most, Integer.MAX_VALUE), recording);
        if (kept.test(x, y)) recording.plot(x, y);
    }

    /** The kept pixels, in the order in which they came. */
    public PixelRecording recording() {
        return recording;
    }
}
