package rasterlab.engine.visibility.depth;

import java.util.List;
import rasterlab.contract.DepthFormat;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class DepthMethods {
    private DepthMethods() {}

    static List<Method<DepthFormat>> all() {
        return List.of(
                Method.failing("z16", new FixedDepth(16)),
                Method.failing("z24", new FixedDepth(24)),
                Method.failing("z32", new FixedDepth(32)),
                Method.failing("zfloat", new FloatDepth()),
                Method.failing("reversed-z", new ReversedDepth()),
                Method.failing("linear-16", new LinearDepth(16)),
                Method.failing("incremental-z16", new IncrementalFixed(16)),
                Method.failing("incremental-z24", new IncrementalFixed(24)),
                Method.failing("incremental-float", new IncrementalFloat()));
    }
}
