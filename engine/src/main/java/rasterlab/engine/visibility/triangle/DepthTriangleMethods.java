package rasterlab.engine.visibility.triangle;

import java.util.List;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class DepthTriangleMethods {
    private DepthTriangleMethods() {}

    static List<Method<DepthTriangleFiller>> all() {
        return List.of(
                Method.failing("left-edge-textbook", new LeftEdgeTriangle()),
                Method.failing("slopes", new SlopesTriangle()),
                Method.failing("rows-float", new FloatRowsTriangle()),
                Method.right("rows", new RowsTriangle()),
                Method.right("weights", new WeightsTriangle()));
    }
}
