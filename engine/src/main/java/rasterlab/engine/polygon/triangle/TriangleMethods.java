package rasterlab.engine.polygon.triangle;

import java.util.List;
import rasterlab.contract.PointInTriangle;
import rasterlab.engine.study.Method;

/** The methods that tell whether a point is in a triangle, in teaching order. */
final class TriangleMethods {

    private TriangleMethods() {}

    static List<Method<PointInTriangle>> all() {
        return List.of(
                Method.failing("half-plane", new HalfPlanes()),
                Method.failing("rotation", new Rotation()),
                Method.failing("simplex", new Simplex()),
                Method.failing("sign-int", new SignInt()),
                Method.failing("sign-float", new SignFloat()),
                Method.failing("sign-double", new SignDouble()),
                Method.right("robust", new RobustTriangle()));
    }
}
