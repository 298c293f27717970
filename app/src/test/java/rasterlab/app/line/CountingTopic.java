package rasterlab.app.line;

import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicInteger;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.ForwardingTopic;

/** The topic of lines, whose exact lines are counted and may be held back. */
final class CountingTopic extends ForwardingTopic<LineRasterizer, Segment, PixelRecording> {
    final AtomicInteger made = new AtomicInteger();
    final Semaphore mayGoOn = new Semaphore(10_000);

    CountingTopic() {
        super(new LineTopic());
    }

    @Override
    public PixelRecording exact(Segment segment, int limit) {
        made.incrementAndGet();
        mayGoOn.acquireUninterruptibly();
        return super.exact(segment, limit);
    }
}
