package rasterlab.engine.fill;

import rasterlab.contract.PixelGrid;
import rasterlab.contract.Pixels;

/** Passes everything on to a picture, counts it, and reports each write. */
public final class WatchedPicture implements PixelGrid {
    private final PixelGrid picture;
    private final Pixels onWrite;
    private long reads;
    private long writes;

    /**
     * @param onWrite told of each write before it happens; may stop the writer by throwing
     */
    public WatchedPicture(PixelGrid picture, Pixels onWrite) {
        this.picture = picture;
        this.onWrite = onWrite;
    }

    @Override
    public int width() {
        return picture.width();
    }

    @Override
    public int height() {
        return picture.height();
    }

    @Override
    public int read(int x, int y) {
        reads++;
        return picture.read(x, y);
    }

    @Override
    public void write(int x, int y, int color) {
        onWrite.plot(x, y);
        writes++;
        picture.write(x, y, color);
    }

    /** Number of pixels read so far, each as often as it was read. */
    public long reads() {
        return reads;
    }

    /** Number of pixels written so far, each as often as it was written. */
    public long writes() {
        return writes;
    }
}
