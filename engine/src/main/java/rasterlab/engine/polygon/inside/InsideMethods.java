package rasterlab.engine.polygon.inside;

import java.util.List;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.study.Method;

/** The methods that tell whether a point is in a polygon, in teaching order. */
final class InsideMethods {
    private InsideMethods() {}

    static List<Method<PointInPolygon>> all() {
        return List.of(
                Method.failing("ray-naive", new RayNaive()),
                Method.failing("ray", new RayCrossing()),
                Method.failing("winding", new Winding()),
                Method.right("robust", new RobustRay()));
    }
}
