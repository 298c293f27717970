package rasterlab.engine.spline.function;

import java.util.List;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Method;

/** The methods that put a function through points; each is a {@link SteppedSpline}. */
final class SplineMethods {
    private SplineMethods() {}

    static List<Method<SplineFunction>> all() {
        return List.of(
                Method.failing("cubic", new CubicSpline()),
                Method.failing("monotone", new MonotoneSpline()),
                Method.failing("cubic-textbook", new UniformTextbookSpline()));
    }
}
