package rasterlab.engine.circle;

import java.util.List;
import java.util.Optional;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Workload;

/** Drawing an ellipse whose axes lie along rows and columns. */
public final class EllipseTopic extends ArcTopic<EllipseRasterizer, Ellipse> {
    @Override
    public String name() {
        return "ellipse";
    }

    @Override
    public Class<EllipseRasterizer> contract() {
        return EllipseRasterizer.class;
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
        return ArcWorkloads.ellipses();
    }

    @Override
    public List<Mutant<EllipseRasterizer>> mutants() {
        return EllipseMutants.all();
    }

    @Override
    public List<Slip<EllipseRasterizer>> slips(EllipseRasterizer right) {
        return EllipseSlips.of(right);
    }

    @Override
    void draw(EllipseRasterizer method, Ellipse e, Pixels out) {
        method.draw(e.centerX(), e.centerY(), e.radiusX(), e.radiusY(), out);
    }

    @Override
    Optional<WalkAndWork> walk(EllipseRasterizer method, Ellipse e) {
        return method instanceof SteppedEllipse stepped
                ? Optional.of(
                        new WalkAndWork(stepped.walk(e.radiusX(), e.radiusY()), stepped.work()))
                : Optional.empty();
    }

    @Override
    Ellipse ellipse(Ellipse e) {
        return e;
    }

    @Override
    public Format<EllipseRasterizer, Ellipse, PixelRecording> format() {
        return new EllipseFormat(this);
    }
}
