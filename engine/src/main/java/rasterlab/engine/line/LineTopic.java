package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Drawing a straight segment.
 *
 * <p>A line that is not exact is degraded where no exact pixel is farther than one pixel from a
 * drawn one and no drawn pixel farther than one pixel from an exact one; otherwise it is wrong.
 */
public final class LineTopic implements Topic<LineRasterizer, Segment, PixelRecording> {
    private static final double USABLE_PIXELS = 1;

    @Override
    public String name() {
        return "line";
    }

    @Override
    public List<Method<LineRasterizer>> methods() {
        return LineMethods.all();
    }

    @Override
    public List<Hazard<Segment>> hazards() {
        return LineHazards.all();
    }

    @Override
    public List<Workload<Segment>> workloads() {
        return LineWorkloads.all();
    }

    @Override
    public PixelRecording record(LineRasterizer method, Segment segment, int limit) {
        var recording = new PixelRecording(limit);
        method.draw(segment.x0(), segment.y0(), segment.x1(), segment.y1(), recording);
        return recording;
    }

    /**
     * {@inheritDoc}
     *
     * @throws LimitReached when the method draws more than {@link #mostBeforeEndless}
     */
    @Override
    public long spend(LineRasterizer method, Segment segment) {
        var counting = new CountingPixels(mostBeforeEndless(segment.steps() + 1));
        method.draw(segment.x0(), segment.y0(), segment.x1(), segment.y1(), counting);
        return counting.count();
    }

    @Override
    public PixelRecording exact(Segment segment, int limit) {
        return new ExactLine(segment).record(limit);
    }

    @Override
    public Deviation compare(Segment segment, PixelRecording exact, PixelRecording actual) {
        return LineComparison.compare(exact, actual);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE_PIXELS;
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
