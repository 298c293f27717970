package rasterlab.engine.polygon.inside;

import java.util.List;
import rasterlab.contract.PointInPolygon;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that tell whether a point is in a polygon, in teaching order. */
final class InsideMethods {
    private InsideMethods() {}

    static List<Method<PointInPolygon>> all() {
        return List.of(rayNaive(), ray(), winding(), robust());
    }

    private static Method<PointInPolygon> rayNaive() {
        return new Method<>(
                "ray-naive",
                new About(
                        "odd number of edges with min(y0, y1) ≤ y ≤ max(y0, y1) and x0 + t·(x1 −"
                                + " x0) ≥ x",
                        "each crossing of the ray changes from inside to outside or back",
                        "one division and one multiplication per edge at the ray's height",
                        "a ray through a corner counts both its edges; points on the boundary;"
                                + " rounding near an edge",
                        "the course's lecture text on points and polygons, before its rule for"
                                + " corners"),
                new RayNaive());
    }

    private static Method<PointInPolygon> ray() {
        return new Method<>(
                "ray",
                new About(
                        "odd number of edges with min(y0, y1) < y ≤ max(y0, y1) and x0 + t·(x1 −"
                                + " x0) ≥ x",
                        "of a corner's two edges the ray meets both, none or one, as it touches or"
                                + " passes",
                        "one division and one multiplication per edge at the ray's height",
                        "points on the boundary fall to either; rounding near an edge; differences"
                                + " beyond 10³⁰⁸",
                        "the course's lecture text on points and polygons"),
                new Ray());
    }

    private static Method<PointInPolygon> winding() {
        return new Method<>(
                "winding",
                new About(
                        "edges going up with the point on their left minus edges going down with"
                                + " it on their right, not 0",
                        "the count is how often the polygon winds round the point",
                        "two multiplications per edge at the point's height",
                        "polygons that cover themselves twice, where it follows the non-zero rule;"
                                + " points on the boundary; rounding near an edge",
                        "K. Hormann, A. Agathos, The point in polygon problem for arbitrary"
                                + " polygons, Computational Geometry 20, 2001"),
                new Winding());
    }

    private static Method<PointInPolygon> robust() {
        return new Method<>(
                "robust",
                new About(
                        "odd number of edges crossed to the right, by exact orientation; or on an"
                                + " edge",
                        "each crossing of the ray changes from inside to outside or back",
                        "one orientation per edge at the point's height and not left of it",
                        "none known for finite doubles",
                        "exact signs after J. R. Shewchuk, Adaptive precision floating-point"
                                + " arithmetic and fast robust geometric predicates, 1997"),
                new RobustRay());
    }
}
