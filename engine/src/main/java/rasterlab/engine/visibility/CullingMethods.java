package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;

/** Methods that look at each face by itself. */
final class CullingMethods {

    private CullingMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                Method.failing("none", new MeshOrder()),
                Method.failing("back-face", new BackFaceCulling()),
                Method.right("convex", new ConvexFaces()));
    }
}
