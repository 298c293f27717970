package rasterlab.engine.visibility.hidden;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.ray.RayCast;
import rasterlab.engine.visibility.scan.ScanLine;
import rasterlab.engine.visibility.scan.Warnock;

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
