package rasterlab.engine.transform.chain;

import java.util.List;
import rasterlab.contract.PointTransformer;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class TransformMethods {

    private TransformMethods() {}

    static List<Method<PointTransformer>> all() {
        return List.of(
                Method.failing("divide-first-textbook", new DivideFirstTransformer()),
                Method.failing("float", new FloatTransformer()),
                Method.failing("double", new DoubleTransformer()),
                Method.right("double-double", new DoubleDoubleTransformer()));
    }
}
