package rasterlab.engine.polygon.scan;

import java.util.List;
import rasterlab.contract.PolygonFiller;
import rasterlab.engine.study.Method;

/** The methods that fill a polygon, in teaching order. */
final class PolygonMethods {
    private PolygonMethods() {}

    static List<Method<PolygonFiller>> all() {
        return List.of(
                Method.failing("naive", new NaivePolygon()),
                Method.right("scanline", new ScanlinePolygon()),
                Method.failing("edge-function", new EdgeFunctionPolygon()));
    }
}
