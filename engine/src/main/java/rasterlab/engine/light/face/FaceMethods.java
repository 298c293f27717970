package rasterlab.engine.light.face;

import java.util.List;
import rasterlab.contract.FaceShader;
import rasterlab.engine.study.Method;

/** The methods of the topic, in teaching order. */
final class FaceMethods {
    static final String GOURAUD = "gouraud";

    private FaceMethods() {}

    static List<Method<FaceShader>> all() {
        return List.of(
                Method.failing("flat-textbook", new FlatFace(true)),
                Method.failing("flat", new FlatFace(false)),
                Method.failing(GOURAUD, new GouraudFace()),
                Method.failing("phong-textbook", new ShortNormalFace()),
                Method.right("phong", new PhongFace()));
    }
}
