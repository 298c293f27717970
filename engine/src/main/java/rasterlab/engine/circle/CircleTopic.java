package rasterlab.engine.circle;

import java.util.List;
import java.util.Optional;
import rasterlab.contract.CircleRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Slip;
import rasterlab.engine.study.Workload;

/** Drawing a circle. */
public final class CircleTopic extends ArcTopic<CircleRasterizer, Circle> {
    @Override
    public String name() {
        return "circle";
    }

    @Override
    public Class<CircleRasterizer> contract() {
        return CircleRasterizer.class;
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
        return ArcWorkloads.circles();
    }

    @Override
    public List<Mutant<CircleRasterizer>> mutants() {
        return CircleMutants.all();
    }

    @Override
    public List<Slip<CircleRasterizer>> slips(CircleRasterizer right) {
        return CircleSlips.of(right);
    }

    @Override
    void draw(CircleRasterizer method, Circle c, Pixels out) {
        method.draw(c.centerX(), c.centerY(), c.radius(), out);
    }

    @Override
    Optional<WalkAndWork> walk(CircleRasterizer method, Circle c) {
        return method instanceof SteppedCircle stepped
                ? Optional.of(new WalkAndWork(stepped.walk(c.radius()), stepped.work()))
                : Optional.empty();
    }

    @Override
    Ellipse ellipse(Circle c) {
        return new Ellipse(c.centerX(), c.centerY(), c.radius(), c.radius());
    }

    @Override
    public Format<CircleRasterizer, Circle, PixelRecording> format() {
        return new CircleFormat(this);
    }
}
