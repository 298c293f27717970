package rasterlab.engine.visibility.order;

import java.util.List;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.study.Method;

/** The methods that order polygons by depth, in teaching order. */
final class DepthOrderMethods {
    private DepthOrderMethods() {}

    static List<Method<DepthOrder>> all() {
        return List.of(
                Method.failing("mean-z-textbook", new MeanZTextbook()),
                Method.failing("mean-z", new MeanZ()),
                Method.right("newell", new Newell()),
                Method.right("bsp", new Bsp()));
    }
}
