package rasterlab.engine.circle;

import java.util.Map;
import java.util.Optional;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.CountingPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.SampledPixels;
import rasterlab.engine.raster.SetComparison;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Topic;

/**
 * Base of the topics of circles and ellipses.
 *
 * <p>A curve that is not exact is degraded where no exact pixel is farther than one pixel from a
 * drawn one and no drawn pixel farther than one pixel from an exact one; otherwise it is wrong.
 *
 * @param <C> the contract that methods implement
 * @param <I> one input
 */
abstract class ArcTopic<C, I> implements Topic<C, I, PixelRecording> {
    /** The most pixels of a figure that {@link #whole} answers, to be drawn in a lab. */
    public static final int MOST_SHOWN = 1_000_000;

    /** The most pixels of a figure that is judged by all of them. */
    private static final int MOST_ITEMS = 2_000_000;

    private static final int SLACK = 1_000;

    abstract void draw(C method, I input, Pixels out);

    /** The walk of a method that has steps, and its work. */
    abstract Optional<WalkAndWork> walk(C method, I input);

    /** The input as an ellipse. */
    abstract Ellipse ellipse(I input);

    /** A walk not begun yet. */
    record WalkAndWork(ArcWalk walk, ArcWork work) {
        Map<String, Long> operations() {
            return ArcCount.of(walk).operations(work);
        }
    }

    @Override
    public String lab() {
        return "line";
    }

    @Override
    public PixelRecording run(C method, I input, int limit) {
        var recording = new PixelRecording(limit);
        draw(method, input, recording);
        return recording;
    }

    @Override
    public long spend(C method, I input) {
        var counting = new CountingPixels(mostDrawn(ellipse(input)));
        draw(method, input, counting);
        return counting.count();
    }

    /** Twice the pixels that a figure has at most, four for each column and row of a quadrant. */
    private static long mostDrawn(Ellipse e) {
        return 8L * ((long) e.radiusX() + e.radiusY()) + SLACK;
    }

    /** {@inheritDoc} Methods draw in different orders, so the part is chosen by place. */
    @Override
    public PixelRecording recordPart(C method, I input, int limit) {
        Ellipse e = ellipse(input);
        if (mostDrawn(e) / 2 <= MOST_ITEMS) return record(method, input, limit);
        var sample = new SampledPixels(new ArcSample(e), mostDrawn(e), limit);
        draw(method, input, sample);
        return sample.recording();
    }

    @Override
    public PixelRecording exactPart(I input, int limit) {
        Ellipse e = ellipse(input);
        if (mostDrawn(e) / 2 <= MOST_ITEMS) return exact(input, limit);
        return new ArcSample(e).exact(limit);
    }

    @Override
    public PixelRecording exact(I input, int limit) {
        Ellipse e = ellipse(input);
        var recording = new PixelRecording(limit);
        new ExactEllipse(e.radiusX(), e.radiusY())
                .draw(e.centerX(), e.centerY(), (x, y) -> keep(recording, limit, x, y));
        return recording;
    }

    /**
     * The right answer with nothing cut off; empty where it has more than 1,000,000 pixels. A
     * figure has at least one pixel for each of its columns and of its rows.
     */
    public Optional<PixelRecording> whole(I input) {
        Ellipse e = ellipse(input);
        if (2L * Math.max(e.radiusX(), e.radiusY()) + 1 > MOST_SHOWN) return Optional.empty();
        return Optional.of(exact(input, MOST_SHOWN + 1)).filter(all -> all.size() <= MOST_SHOWN);
    }

    private static void keep(PixelRecording recording, int limit, int x, int y) {
        if (recording.size() < limit) recording.plot(x, y);
    }

    @Override
    public Deviation compare(I input, PixelRecording exact, PixelRecording actual) {
        return SetComparison.compare(exact, actual);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= SetComparison.USABLE_PIXELS;
    }

    @Override
    public Map<String, Long> operations(C method, I input) {
        return walk(method, input).map(WalkAndWork::operations).orElse(Map.of());
    }

    /** {@inheritDoc} No part of a larger one reaches it. */
    @Override
    public int mostItems() {
        return MOST_ITEMS;
    }

    @Override
    public String item() {
        return "pixel";
    }

    @Override
    public String errorUnit() {
        return "pixels";
    }
}
