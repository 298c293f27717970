package rasterlab.engine.polygon.scan;

import java.util.List;
import java.util.Map;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.SetComparison;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Filling a polygon.
 *
 * <p>An output that is not exact is degraded where no exact pixel is farther than one pixel from a
 * filled one and no filled pixel farther than one pixel from an exact one; otherwise it is wrong.
 * The right pixels in another order than row by row from left to right are degraded, too.
 */
public final class PolygonFillTopic implements Topic<PolygonFiller, PolygonTask, PixelRecording> {
    private static final int MOST_ITEMS = 1_000_000;

    @Override
    public String name() {
        return "polygon-fill";
    }

    @Override
    public String lab() {
        return "polygon";
    }

    @Override
    public Class<PolygonFiller> contract() {
        return PolygonFiller.class;
    }

    @Override
    public List<Method<PolygonFiller>> methods() {
        return PolygonMethods.all();
    }

    @Override
    public List<Hazard<PolygonTask>> hazards() {
        return PolygonHazards.all();
    }

    @Override
    public List<Workload<PolygonTask>> workloads() {
        return PolygonWorkloads.all();
    }

    @Override
    public List<Mutant<PolygonFiller>> mutants() {
        return PolygonFillMutants.all();
    }

    @Override
    public List<Slip<PolygonFiller>> slips(PolygonFiller right) {
        return PolygonFillSlips.of(right);
    }

    @Override
    public PixelRecording run(PolygonFiller method, PolygonTask task, int limit) {
        var recording = new PixelRecording(limit);
        method.fill(
                task.x(),
                task.y(),
                task.rule(),
                task.width(),
                task.height(),
                (y, from, to) -> {
                    for (int x = from; x < to; x++) recording.plot(x, y);
                });
        return recording;
    }

    @Override
    public long spend(PolygonFiller method, PolygonTask task) {
        var pixels = new long[1];
        method.fill(
                task.x(),
                task.y(),
                task.rule(),
                task.width(),
                task.height(),
                (y, from, to) -> pixels[0] += to - from);
        return pixels[0];
    }

    @Override
    public PixelRecording exact(PolygonTask task, int limit) {
        var recording = new PixelRecording(limit);
        if (!finite(task.x()) || !finite(task.y())) return recording;
        new ExactFill(task)
                .fill(
                        (y, from, to) -> {
                            for (int x = from; x < to && recording.size() < limit; x++)
                                recording.plot(x, y);
                        });
        return recording;
    }

    /** A polygon with a corner nowhere has no pixels. */
    private static boolean finite(double[] values) {
        for (double value : values) if (!Double.isFinite(value)) return false;
        return true;
    }

    @Override
    public Deviation compare(PolygonTask task, PixelRecording exact, PixelRecording actual) {
        Deviation set = SetComparison.compare(exact, actual);
        if (!set.exact()) return set;
        for (int i = 0; i < exact.size(); i++)
            if (exact.x(i) != actual.x(i) || exact.y(i) != actual.y(i))
                return new Deviation(
                        0,
                        0,
                        0,
                        exact.size(),
                        "pixel (%d, %d) is filled where (%d, %d) is next"
                                .formatted(actual.x(i), actual.y(i), exact.x(i), exact.y(i)));
        return set;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= SetComparison.USABLE_PIXELS;
    }

    @Override
    public Map<String, Long> operations(PolygonFiller method, PolygonTask task) {
        if (!(method instanceof SteppedPolygon stepped)) return Map.of();
        SpanWalk walk = stepped.walk(task.x(), task.y(), task.rule(), task.width(), task.height());
        boolean more = walk.advance();
        while (more) more = walk.advance();
        return walk.operations();
    }

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

    @Override
    public Format<PolygonFiller, PolygonTask, PixelRecording> format() {
        return new PolygonFillFormat(this);
    }
}
