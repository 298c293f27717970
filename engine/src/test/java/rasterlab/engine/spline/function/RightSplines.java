package rasterlab.engine.spline.function;

import java.util.List;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.study.Method;

/** The methods that take knots at any distance and refuse what is none. */
final class RightSplines {
    private RightSplines() {}

    static List<Method<SplineFunction>> all() {
        SplineFunctionTopic topic = new SplineFunctionTopic();
        return List.of(topic.method("cubic"), topic.method("monotone"));
    }
}
