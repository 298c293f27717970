package rasterlab.engine.light.normals;

import java.util.List;
import rasterlab.contract.VertexNormals;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class NormalsMethods {
    private NormalsMethods() {}

    static List<Method<VertexNormals>> all() {
        return List.of(
                Method.failing("plain-textbook", new SummedNormals()),
                Method.failing("plain", new WeightedNormals(Weight.PLAIN)),
                Method.failing("area", new WeightedNormals(Weight.AREA)),
                Method.right("angle", new WeightedNormals(Weight.ANGLE)));
    }
}
