package rasterlab.engine.visibility.painter;

import java.util.List;
import rasterlab.engine.study.Method;
import rasterlab.engine.visibility.Visibility;

/** Methods that paint faces or pieces of them, the farthest first. */
public final class PaintingMethods {

    private PaintingMethods() {}

    public static List<Method<Visibility>> all() {
        return List.of(
                Method.failing("painter-textbook", new TextbookPainter()),
                Method.failing("painter", new Painter()),
                Method.right("newell", new OrderedPieces("newell")),
                Method.right("bsp", new OrderedPieces("bsp")));
    }
}
