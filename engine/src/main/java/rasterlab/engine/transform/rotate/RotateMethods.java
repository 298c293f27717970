package rasterlab.engine.transform.rotate;

import java.util.List;
import rasterlab.contract.PlaneRotation;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class RotateMethods {

    private RotateMethods() {}

    static List<Method<PlaneRotation>> all() {
        return List.of(
                Method.failing("direct", new DirectRotation()),
                Method.failing("float", new FloatRotation()),
                Method.failing("table", new TableRotation()),
                Method.failing("buneman-textbook", new BunemanTextbookRotation()),
                Method.failing("buneman", new BunemanRotation()),
                Method.failing("orthonormal", new OrthonormalRotation()),
                Method.failing("quaternion", new QuaternionRotation()),
                Method.right("total-angle", new TotalAngleRotation()));
    }
}
