package rasterlab.app.row;

import java.util.List;
import rasterlab.contract.DepthFormat;
import rasterlab.engine.study.ForwardingTopic;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.depth.DepthBufferTopic;
import rasterlab.engine.visibility.depth.DepthRows;
import rasterlab.engine.visibility.depth.StoredDepths;

/** Depths as they are stored, but one of the methods crashes. */
final class CrashingDepths extends ForwardingTopic<DepthFormat, DepthRows, StoredDepths> {
    private final List<Method<DepthFormat>> methods = super.methods();
    private final DepthFormat broken;

    CrashingDepths(String method) {
        super(new DepthBufferTopic());
        broken = method(method).implementation();
    }

    @Override
    public StoredDepths record(DepthFormat method, DepthRows rows, int limit) {
        if (method == broken) throw new ArithmeticException("broken");
        return super.record(method, rows, limit);
    }

    /** These objects each time, so that the broken one is known. */
    @Override
    public List<Method<DepthFormat>> methods() {
        return methods;
    }
}
