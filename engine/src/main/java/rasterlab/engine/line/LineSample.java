package rasterlab.engine.line;

import java.util.function.Consumer;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.LimitReached;

/**
 * The pixels by which a line is judged that has too many to keep: stretches of it, evenly spread
 * from its first pixel to its last, counted as they come.
 *
 * <p>A line of more than {@value #MOST_DRAWN} pixels would take too long: only so many are drawn
 * from its beginning, and what follows is not judged.
 */
final class LineSample implements Pixels {
    /** 2²⁶, which takes some tenths of a second: beyond all whole numbers that a float has. */
    static final long MOST_DRAWN = 1 << 26;

    private static final int STRETCHES = 16;
    private static final int LENGTH = 1_000;

    private final long whole;
    private final long drawn;
    private final int limit;
    private final PixelRecording recording;
    private long index;
    private int stretch;
    private long from;
    private long to = LENGTH;

    /**
     * @param limit the most pixels to keep
     */
    LineSample(Segment segment, int limit) {
        whole = segment.steps() + 1;
        drawn = Math.min(whole, MOST_DRAWN);
        this.limit = limit;
        recording = new PixelRecording(limit);
    }

    /** Stops a method that has drawn as many pixels as are looked at. */
    private static final class SampleFull extends RuntimeException {
        private static final long serialVersionUID = 1L;

        SampleFull() {
            super("enough", null, false, false);
        }
    }

    /** Whether a line is judged by a part of it. */
    static boolean isNeeded(Segment segment, int mostItems) {
        return segment.isWhole() && segment.steps() >= mostItems;
    }

    /** Records the kept part of what {@code line} draws. */
    PixelRecording of(Consumer<Pixels> line) {
        try {
            line.accept(this);
        } catch (SampleFull e) {
            // The sample is full: the method has drawn all that is compared.
        }
        return recording;
    }

    @Override
    public void plot(int x, int y) {
        if (index >= to && stretch < STRETCHES - 1) next();
        if (index >= from) keep(x, y);
        index++;
    }

    private void keep(int x, int y) {
        if (index < to) recording.plot(x, y);
        else if (drawn < whole) throw new SampleFull();
        else beyond(x, y);
    }

    /** Pixels that the line does not have. */
    private void beyond(int x, int y) {
        if (index > 2 * whole) throw new LimitReached(limit, recording);
        recording.plot(x, y);
    }

    private void next() {
        stretch++;
        from = stretch * (drawn - LENGTH) / (STRETCHES - 1);
        to = from + LENGTH;
    }

    /** The right pixels. */
    static PixelRecording exact(Segment segment, int limit) {
        var exact = new ExactLine(segment);
        var sample = new LineSample(segment, limit);
        for (; sample.stretch < STRETCHES; sample.next())
            for (long k = sample.from; k < sample.to && sample.recording.size() < limit; k++)
                sample.recording.plot(exact.x(k), exact.y(k));
        return sample.recording;
    }
}
