package rasterlab.app.row;

import java.util.List;
import rasterlab.contract.DepthFormat;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.depth.DepthRows;
import rasterlab.engine.visibility.depth.StoredDepths;

/** Depths as they are stored, but one of the methods crashes. */
final class CrashingDepths implements Topic<DepthFormat, DepthRows, StoredDepths> {
    private final DepthBufferTopic whole = new DepthBufferTopic();
    private final List<Method<DepthFormat>> methods = whole.methods();
    private final DepthFormat broken;

    CrashingDepths(String method) {
        broken = method(method).implementation();
    }

    @Override
    public StoredDepths record(DepthFormat method, DepthRows rows, int limit) {
        if (method == broken) throw new ArithmeticException("broken");
        return whole.record(method, rows, limit);
    }

    @Override
    public String name() {
        return whole.name();
    }

    @Override
    public List<Method<DepthFormat>> methods() {
        return methods;
    }

    @Override
    public List<Hazard<DepthRows>> hazards() {
        return whole.hazards();
    }

    @Override
    public List<Workload<DepthRows>> workloads() {
        return whole.workloads();
    }

    @Override
    public long spend(DepthFormat method, DepthRows rows) {
        return whole.spend(method, rows);
    }

    @Override
    public StoredDepths exact(DepthRows rows, int limit) {
        return whole.exact(rows, limit);
    }

    @Override
    public Deviation compare(DepthRows rows, StoredDepths exact, StoredDepths actual) {
        return whole.compare(rows, exact, actual);
    }

    @Override
    public String item() {
        return whole.item();
    }

    @Override
    public String errorUnit() {
        return whole.errorUnit();
    }
}
