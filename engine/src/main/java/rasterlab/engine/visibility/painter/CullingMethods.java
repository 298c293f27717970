package rasterlab.engine.visibility.painter;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.Visibility;

/** Methods that look at each face by itself. */
public final class CullingMethods {

    private CullingMethods() {}

    public static List<Method<Visibility>> all() {
        return List.of(
                Method.failing("none", new MeshOrder()),
                Method.failing("back-face", new BackFaceCulling()),
                Method.right("convex", new ConvexFaces()));
    }
}
