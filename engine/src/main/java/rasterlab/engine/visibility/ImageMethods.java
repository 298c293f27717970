package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;

/** Methods that ask of parts of the picture which face is seen there. */
final class ImageMethods {
    private ImageMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                Method.right("scanline", new ScanLine()), Method.right("warnock", new Warnock()));
    }

    static Method<Visibility> rayCast() {
        return Method.right("raycast", new RayCast());
    }
}
