package rasterlab.engine.polygon.triangulation;

import java.util.List;
import rasterlab.contract.Triangulator;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that cut a polygon into triangles, in teaching order. */
final class TriangulateMethods {
    private TriangulateMethods() {}

    static List<Method<Triangulator>> all() {
        return List.of(
                fan(),
                shortestDiagonalPrintedTextbook(),
                shortestDiagonalTextbook(),
                shortestDiagonal(),
                earClipping());
    }

    private static Method<Triangulator> fan() {
        return new Method<>(
                "fan",
                new About(
                        "triangles (0, i, i + 1), or (i + 1, i, 0) clockwise, i = 1 … n − 2",
                        "the triangles so far cover the corners 0 … i + 1",
                        "3·n − 3 exact turns to see that the polygon is convex, then nothing",
                        "polygons that are not convex, and corners on the sides at corner 0:"
                                + " refused",
                        "the course's lecture text on triangulation, first listing"),
                new Fan());
    }

    private static Method<Triangulator> shortestDiagonalPrintedTextbook() {
        return new Method<>(
                "shortest-diagonal-printed-textbook",
                new About(
                        "h = i − 1, then h = i + 1 where j = i + 1 is meant; cut i where D = (xi −"
                                + " xh)·(yj − yh) − (xj − xh)·(yi − yh) > 10⁻⁶ and the diagonal"
                                + " from h to j is shortest",
                        "none; j is never set",
                        "nothing, since the first turn is never computed",
                        "every polygon, as the first turn asks for corner V(0), and corners count from"
                                + " 1",
                        "the course's lecture text on triangulation, second listing as printed"),
                new ShortestDiagonalPrintedTextbook());
    }

    private static Method<Triangulator> shortestDiagonalTextbook() {
        return new Method<>(
                "shortest-diagonal-textbook",
                new About(
                        "cut i where D = (xi − xh)·(yj − yh) − (xj − xh)·(yi − yh) > 10⁻⁶ and the"
                                + " diagonal from h to j is shortest",
                        "what is left is a polygon with one corner less",
                        "4 multiplications per corner left and cut: 2·n² for n corners",
                        "a corner inside the triangle that is cut; corners given clockwise; small"
                                + " units, where D is never above 10⁻⁶, and diagonals beyond 10¹⁵",
                        "the course's lecture text on triangulation, second listing, two slips"
                                + " mended"),
                new ShortestDiagonalTextbook());
    }

    private static Method<Triangulator> shortestDiagonal() {
        return new Method<>(
                "shortest-diagonal",
                new About(
                        "cut the ear whose diagonal from h to j is shortest",
                        "what is left is a simple polygon with one corner less",
                        "n²/2 diagonals and up to 3·n tries of an ear against the corners that are"
                                + " not convex",
                        "none known up to 20,000 corners; more are refused",
                        "the course's lecture text on triangulation, with the ears of G. H."
                                + " Meisters, Polygons have ears, 1975"),
                new ShortestDiagonal());
    }

    private static Method<Triangulator> earClipping() {
        return new Method<>(
                "ear-clipping",
                new About(
                        "cut any corner with a left turn and no other corner in its triangle",
                        "what is left is a simple polygon with one corner less",
                        "up to 3·n tries of an ear against the corners that are not convex",
                        "none known up to 20,000 corners; more are refused",
                        "G. H. Meisters, Polygons have ears, American Mathematical Monthly 82,"
                                + " 1975"),
                new EarClipping());
    }
}
