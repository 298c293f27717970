package rasterlab.engine.visibility.hidden;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.buffer.DepthBufferMethods;
import rasterlab.engine.visibility.painter.CullingMethods;
import rasterlab.engine.visibility.painter.DepthOrderPainter;
import rasterlab.engine.visibility.painter.PaintingMethods;
import rasterlab.engine.visibility.painter.VisibleFacesPainter;

/** The visibility methods that can be named, in teaching order. */
public final class Visibilities {
    private final List<Method<Visibility>> methods =
            Stream.of(
                            CullingMethods.all(),
                            PaintingMethods.all(),
                            ImageMethods.all(),
                            DepthBufferMethods.all(),
                            List.of(ImageMethods.rayCast()))
                    .flatMap(List::stream)
                    .toList();

    /** Draws the faces that a method of topic {@code visible-faces} calls visible. */
    public static Visibility by(VisibleFaces method) {
        return new VisibleFacesPainter(method);
    }

    /** Paints faces in the order that a method of topic {@code depth-order} gives. */
    public static Visibility by(DepthOrder method) {
        return new DepthOrderPainter(method);
    }

    public List<Method<Visibility>> methods() {
        return methods;
    }

    /**
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public Method<Visibility> named(String name) {
        return Named.find("visibility method", name, methods, Method::name);
    }
}
