package rasterlab.engine.visibility;

import java.util.List;
import rasterlab.engine.study.Method;

/** Methods that paint faces or pieces of them, the farthest first. */
final class PaintingMethods {

    private PaintingMethods() {}

    static List<Method<Visibility>> all() {
        return List.of(
                Method.failing("painter-textbook", new TextbookPainter()),
                Method.failing("painter", new Painter()),
                Method.right("newell", new OrderedPieces("newell")),
                Method.right("bsp", new OrderedPieces("bsp")));
    }
}
