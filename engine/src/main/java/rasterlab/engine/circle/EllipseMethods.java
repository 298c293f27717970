package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.study.Method;

/** The methods that draw an ellipse, in teaching order. */
final class EllipseMethods {
    private EllipseMethods() {}

    static List<Method<EllipseRasterizer>> all() {
        return List.of(
                Method.failing("parametric", new ParametricEllipse()),
                Method.failing("bresenham-textbook", new BresenhamTextbookEllipse()),
                Method.right("bresenham", new BresenhamEllipse()),
                Method.right("midpoint", new MidpointEllipse()));
    }
}
