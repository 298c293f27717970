package rasterlab.app.line;

import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/** The topic of lines, whose exact lines are counted and may be held back. */
final class CountingTopic implements Topic<LineRasterizer, Segment, PixelRecording> {
    final AtomicInteger made = new AtomicInteger();
    final Semaphore mayGoOn = new Semaphore(10_000);
    private final LineTopic lines = new LineTopic();

    @Override
    public PixelRecording exact(Segment segment, int limit) {
        made.incrementAndGet();
        mayGoOn.acquireUninterruptibly();
        return lines.exact(segment, limit);
    }

    @Override
    public String name() {
        return lines.name();
    }

    @Override
    public List<Method<LineRasterizer>> methods() {
        return lines.methods();
    }

    @Override
    public List<Hazard<Segment>> hazards() {
        return lines.hazards();
    }

    @Override
    public List<Workload<Segment>> workloads() {
        return lines.workloads();
    }

    @Override
    public PixelRecording record(LineRasterizer method, Segment segment, int limit) {
        return lines.record(method, segment, limit);
    }

    @Override
    public long spend(LineRasterizer method, Segment segment) {
        return lines.spend(method, segment);
    }

    @Override
    public Deviation compare(Segment segment, PixelRecording exact, PixelRecording actual) {
        return lines.compare(segment, exact, actual);
    }

    @Override
    public String item() {
        return lines.item();
    }

    @Override
    public String errorUnit() {
        return lines.errorUnit();
    }
}
