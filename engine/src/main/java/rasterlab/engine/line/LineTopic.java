package rasterlab.engine.line;

import java.util.List;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.raster.CountingPixels;
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
 * drawn one and no drawn pixel farther than one pixel from an exact one; otherwise it is wrong. A
 * line with coverage is compared by the pixels it covers by at least a half.
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
        if (method instanceof CoverageLine shaded) return shade(shaded, segment, counting);
        method.draw(segment.x0(), segment.y0(), segment.x1(), segment.y1(), counting);
        return counting.count();
    }

    /** The coverage is the method's work; per step of the line, which is what others draw. */
    private static long shade(CoverageLine method, Segment s, CountingPixels counting) {
        method.shade(s.x0(), s.y0(), s.x1(), s.y1(), (x, y, coverage) -> counting.plot(x, y));
        return s.steps() + 1;
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
