package rasterlab.app.cli.run;

import rasterlab.app.outcome.Complaint;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;

/** Keeps the pixels of one segment that lie in a window, and stops a method that never ends. */
final class LineSink implements Pixels {
    /** The most pixels in one answer. */
    static final int MOST_PIXELS = 10_000_000;

    private final String method;
    private final PixelWindow window;
    private final long mostWrites;
    private final PixelRecording kept = new PixelRecording(MOST_PIXELS);
    private long writes;

    /**
     * @param exactPixels the number of pixels of the exact segment, from which follows when a
     *     method is taken for endless
     */
    LineSink(String method, PixelWindow window, long exactPixels) {
        this.method = method;
        this.window = window;
        this.mostWrites = new LineTopic().mostBeforeEndless(exactPixels);
    }

    @Override
    public void plot(int x, int y) {
        keep(x, y);
    }

    /** Returns whether the pixel was in the window and is kept. */
    boolean keep(int x, int y) {
        if (++writes > mostWrites) throw endless();
        if (!window.contains(x, y)) return false;
        if (kept.size() == MOST_PIXELS) throw tooMany();
        kept.plot(x, y);
        return true;
    }

    PixelRecording kept() {
        return kept;
    }

    private Complaint endless() {
        return Complaint.gaveUp(
                method
                        + " does not end: it sent more than "
                        + mostWrites
                        + " pixels, more than twice what the segment has");
    }

    private static Complaint tooMany() {
        return Complaint.gaveUp(
                "the answer has more than "
                        + MOST_PIXELS
                        + " pixels, the most that one answer may have; give a smaller \"window\"");
    }
}
