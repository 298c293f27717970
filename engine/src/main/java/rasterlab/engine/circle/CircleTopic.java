package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.CircleRasterizer;
import rasterlab.engine.raster.CountingPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.SetComparison;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Drawing a circle.
 *
 * <p>One that is not exact is degraded where no exact pixel is farther than one pixel from a drawn
 * one and no drawn pixel farther than one pixel from an exact one; otherwise it is wrong.
 */
public final class CircleTopic implements Topic<CircleRasterizer, Circle, PixelRecording> {
    private static final int MOST_ITEMS = 1_000_000;
    private static final int SLACK = 1_000;

    @Override
    public String name() {
        return "circle";
    }

    @Override
    public List<Method<CircleRasterizer>> methods() {
        return CircleMethods.all();
    }

    @Override
    public List<Hazard<Circle>> hazards() {
        return CircleHazards.all();
    }

    @Override
    public List<Workload<Circle>> workloads() {
        return CurveWorkloads.circles();
    }

    @Override
    public PixelRecording record(CircleRasterizer method, Circle c, int limit) {
        var recording = new PixelRecording(limit);
        method.draw(c.centreX(), c.centreY(), c.radius(), recording);
        return recording;
    }

    @Override
    public long spend(CircleRasterizer method, Circle c) {
        var counting = new CountingPixels(16L * c.radius() + SLACK);
        method.draw(c.centreX(), c.centreY(), c.radius(), counting);
        return counting.count();
    }

    @Override
    public PixelRecording exact(Circle c, int limit) {
        var recording = new PixelRecording(limit);
        new ExactEllipse(c.radius(), c.radius())
                .draw(c.centreX(), c.centreY(), (x, y) -> keep(recording, limit, x, y));
        return recording;
    }

    private static void keep(PixelRecording recording, int limit, int x, int y) {
        if (recording.size() < limit) recording.plot(x, y);
    }

    @Override
    public Deviation compare(Circle c, PixelRecording exact, PixelRecording actual) {
        return SetComparison.compare(exact, actual);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= SetComparison.USABLE_PIXELS;
    }

    /** Methods draw in different orders, so no answer is cut. */
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
