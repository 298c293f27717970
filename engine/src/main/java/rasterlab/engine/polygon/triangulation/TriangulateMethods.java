package rasterlab.engine.polygon.triangulation;

import java.util.List;
import rasterlab.contract.Triangulator;
import rasterlab.engine.study.Method;

/** The methods that cut a polygon into triangles, in teaching order. */
final class TriangulateMethods {
    private TriangulateMethods() {}

    static List<Method<Triangulator>> all() {
        return List.of(
                Method.failing("fan", new Fan()),
                Method.failing(
                        "shortest-diagonal-printed-textbook",
                        new ShortestDiagonalPrintedTextbook()),
                Method.failing("shortest-diagonal-textbook", new ShortestDiagonalTextbook()),
                Method.right("shortest-diagonal", new ShortestDiagonal()),
                Method.right("ear-clipping", new EarClipping()));
    }
}
