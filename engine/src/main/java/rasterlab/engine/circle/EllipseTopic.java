package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.raster.CountingPixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.raster.SetComparison;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Drawing an ellipse whose axes lie along rows and columns.
 *
 * <p>One that is not exact is degraded where no exact pixel is farther than one pixel from a drawn
 * one and no drawn pixel farther than one pixel from an exact one; otherwise it is wrong.
 */
public final class EllipseTopic implements Topic<EllipseRasterizer, Ellipse, PixelRecording> {
    private static final int MOST_ITEMS = 1_000_000;
    private static final int SLACK = 1_000;

    @Override
    public String name() {
        return "ellipse";
    }

    @Override
    public List<Method<EllipseRasterizer>> methods() {
        return EllipseMethods.all();
    }

    @Override
    public List<Hazard<Ellipse>> hazards() {
        return EllipseHazards.all();
    }

    @Override
    public List<Workload<Ellipse>> workloads() {
        return CurveWorkloads.ellipses();
    }

    @Override
    public PixelRecording record(EllipseRasterizer method, Ellipse e, int limit) {
        var recording = new PixelRecording(limit);
        method.draw(e.centreX(), e.centreY(), e.radiusX(), e.radiusY(), recording);
        return recording;
    }

    @Override
    public long spend(EllipseRasterizer method, Ellipse e) {
        var counting = new CountingPixels(8L * ((long) e.radiusX() + e.radiusY()) + SLACK);
        method.draw(e.centreX(), e.centreY(), e.radiusX(), e.radiusY(), counting);
        return counting.count();
    }

    @Override
    public PixelRecording exact(Ellipse e, int limit) {
        var recording = new PixelRecording(limit);
        new ExactEllipse(e.radiusX(), e.radiusY())
                .draw(e.centreX(), e.centreY(), (x, y) -> keep(recording, limit, x, y));
        return recording;
    }

    private static void keep(PixelRecording recording, int limit, int x, int y) {
        if (recording.size() < limit) recording.plot(x, y);
    }

    @Override
    public Deviation compare(Ellipse e, PixelRecording exact, PixelRecording actual) {
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
