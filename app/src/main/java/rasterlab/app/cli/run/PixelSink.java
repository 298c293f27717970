package rasterlab.app.cli.run;

import rasterlab.app.outcome.Complaint;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;

/** Keeps the pixels of one figure that lie in a window, and stops a method that never ends. */
final class PixelSink implements Pixels {
    /** The most pixels in one answer. */
    static final int MOST_PIXELS = 10_000_000;

    /**
     * What is drawn, for complaints.
     *
     * @param noun such as "segment"
     * @param advice how to get fewer pixels
     */
    record Figure(String noun, String advice) {}

    private final String method;
    private final Figure figure;
    private final PixelWindow window;
    private final long mostWrites;
    private final PixelRecording kept = new PixelRecording(MOST_PIXELS);
    private long writes;

    /**
     * @param mostWrites the number of pixels after which the method is taken for endless; at least
     *     twice what the figure has
     */
    PixelSink(String method, Figure figure, PixelWindow window, long mostWrites) {
        this.method = method;
        this.figure = figure;
        this.window = window;
        this.mostWrites = mostWrites;
    }

    @Override
    public void plot(int x, int y) {
        keep(x, y);
    }

    /** Returns whether the pixel was in the window and is kept. */
    boolean keep(int x, int y) {
        if (++writes > mostWrites) throw endless();
        if (!window.contains(x, y)) return false;
        if (kept.size() == MOST_PIXELS) throw tooMany(figure.advice());
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
                        + " pixels, more than twice what the "
                        + figure.noun()
                        + " has");
    }

    static Complaint tooMany(String advice) {
        return Complaint.gaveUp(
                "the answer has more than "
                        + MOST_PIXELS
                        + " pixels, the most that one answer may have; "
                        + advice);
    }
}
