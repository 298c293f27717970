package rasterlab.engine.line;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.contract.WindowedLineRasterizer;
import rasterlab.engine.raster.CountingPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
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
    public String lab() {
        return "line";
    }

    @Override
    public Class<LineRasterizer> contract() {
        return LineRasterizer.class;
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
    public List<Mutant<LineRasterizer>> mutants() {
        return LineMutants.all();
    }

    @Override
    public List<Slip<LineRasterizer>> slips(LineRasterizer right) {
        return LineSlips.of(right);
    }

    @Override
    public PixelRecording run(LineRasterizer method, Segment segment, int limit) {
        var recording = new PixelRecording(limit);
        draw(method, segment, recording);
        return recording;
    }

    @Override
    public PixelRecording recordPart(LineRasterizer method, Segment segment, int limit) {
        if (!LineSample.isNeeded(segment, mostItems())) return record(method, segment, limit);
        return new LineSample(segment, limit).of(out -> draw(method, segment, out));
    }

    @Override
    public PixelRecording exactPart(Segment segment, int limit) {
        if (!LineSample.isNeeded(segment, mostItems())) return exact(segment, limit);
        return LineSample.exact(segment, limit);
    }

    /** Sends the pixels of the segment that lie in its window. */
    private static void draw(LineRasterizer method, Segment s, Pixels out) {
        if (s.isWhole()) {
            method.draw(s.x0(), s.y0(), s.x1(), s.y1(), out);
        } else if (method instanceof SteppedLine stepped) {
            LineWalk walk = walk(stepped, s);
            while (walk.advance()) out.plot(walk.x(), walk.y());
        } else if (method instanceof WindowedLineRasterizer windowed) {
            PixelWindow w = s.window();
            windowed.draw(
                    s.x0(), s.y0(), s.x1(), s.y1(), w.xmin(), w.ymin(), w.xmax(), w.ymax(), out);
        } else {
            Pixels seen = (x, y) -> plotSeen(x, y, s.window(), out);
            method.draw(s.x0(), s.y0(), s.x1(), s.y1(), seen);
        }
    }

    private static void plotSeen(int x, int y, PixelWindow window, Pixels out) {
        if (window.contains(x, y)) out.plot(x, y);
    }

    /** A walk over the pixels of the segment that lie in its window. */
    public static LineWalk walk(SteppedLine method, Segment s) {
        if (s.isWhole()) return method.walk(s.x0(), s.y0(), s.x1(), s.y1());
        if (method instanceof WindowedLine windowed)
            return windowed.walk(s.x0(), s.y0(), s.x1(), s.y1(), s.window());
        return new SeenWalk(method.walk(s.x0(), s.y0(), s.x1(), s.y1()), s.window());
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
        draw(method, segment, counting);
        return counting.count();
    }

    /** The coverage is the method's work; per step of the line, which is what others draw. */
    private static long shade(CoverageLine method, Segment s, CountingPixels counting) {
        method.shade(s.x0(), s.y0(), s.x1(), s.y1(), (x, y, coverage) -> counting.plot(x, y));
        return s.steps() + 1;
    }

    /** {@inheritDoc} Beside the arithmetic, the light and the length it falls on. */
    @Override
    public Map<String, Long> operations(LineRasterizer method, Segment segment) {
        if (!(method instanceof SteppedLine stepped)) return Map.of();
        var counts = new TreeMap<String, Long>();
        LineCount.of(stepped, segment).addTo(counts);
        LineBrightness.of(method, segment).addTo(counts);
        return counts;
    }

    /** {@inheritDoc} Light and length are none. */
    @Override
    public boolean isWork(String count) {
        return !count.startsWith(LineBrightness.LEVELS);
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

    @Override
    public Format<LineRasterizer, Segment, PixelRecording> format() {
        return new LineFormat(this);
    }
}
