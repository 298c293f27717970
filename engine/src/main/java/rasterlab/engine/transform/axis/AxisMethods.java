package rasterlab.engine.transform.axis;

import java.util.List;
import rasterlab.contract.AxisRotation;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class AxisMethods {
    private AxisMethods() {}

    static List<Method<AxisRotation>> all() {
        return List.of(
                Method.failing("seven-steps-textbook", new SevenStepsTextbook()),
                Method.right("seven-steps", new SevenSteps()),
                Method.right("rodrigues", new RodriguesRotation()),
                Method.right("quaternion", new QuaternionAxisRotation()));
    }
}
