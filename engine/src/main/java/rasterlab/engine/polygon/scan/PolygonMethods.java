package rasterlab.engine.polygon.scan;

import java.util.List;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that fill a polygon, in teaching order. */
final class PolygonMethods {
    private PolygonMethods() {}

    static List<Method<PolygonFiller>> all() {
        return List.of(naive(), scanline(), edgeFunction());
    }

    private static Method<PolygonFiller> naive() {
        return new Method<>(
                "naive",
                new About(
                        "the crossings of a row with all edges, both ends of an edge included, paired"
                                + " from left to right; a pair is filled from rounded end to rounded"
                                + " end",
                        "none; a row through a corner has one crossing too many",
                        "every edge is looked at in every row",
                        "wrong rows at corners, shared edges drawn twice, no non-zero rule",
                        "the even-odd rule written down without a rule for ties"),
                new NaivePolygon());
    }

    private static Method<PolygonFiller> scanline() {
        return new Method<>(
                "scanline",
                new About(
                        "X = x0 + (y − y0)·(x1 − x0)/(y1 − y0) for y0 ≤ y < y1; the winding number"
                                + " changes by ±1 at the first column that is not left of X",
                        "the active edges are those that cross the row; the winding number is 0"
                                + " beyond the last crossing",
                        "one crossing per active edge and row, and sorting them",
                        "none known",
                        "C. Wylie, G. Romney, D. Evans, A. Erdahl, Half-tone perspective drawings by"
                                + " computer, AFIPS, 1967"),
                new ScanlinePolygon());
    }

    private static Method<PolygonFiller> edgeFunction() {
        return new Method<>(
                "edge-function",
                new About(
                        "E(x, y) = (x − x0)·(y1 − y0) − (y − y0)·(x1 − x0); the edges of the row with"
                                + " E ≥ 0 add their direction to the pixel's winding number",
                        "E is 0 on the edge, above 0 to the right of a downward edge",
                        "one edge function per pixel of the box and edge of the row",
                        "refuses more than 1000000000 edge functions",
                        "J. Pineda, A parallel algorithm for polygon rasterization, SIGGRAPH, 1988"),
                new EdgeFunctionPolygon());
    }
}
