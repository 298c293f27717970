package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.CircleRasterizer;
import rasterlab.engine.study.Method;

/** The methods that draw a circle, in teaching order. */
final class CircleMethods {
    private CircleMethods() {}

    static List<Method<CircleRasterizer>> all() {
        return List.of(
                Method.failing("parametric", new ParametricCircle()),
                Method.failing("bresenham-textbook", new BresenhamTextbookCircle()),
                Method.right("bresenham", new BresenhamCircle()),
                Method.right("midpoint", new MidpointCircle()));
    }
}
