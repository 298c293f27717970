package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that draw an ellipse, in teaching order. */
final class EllipseMethods {
    private EllipseMethods() {}

    static List<Method<EllipseRasterizer>> all() {
        return List.of(parametric(), bresenham(), midpoint());
    }

    private static Method<EllipseRasterizer> parametric() {
        return new Method<>(
                "parametric",
                new About(
                        "u = a·sin t, v = b·cos t, both rounded; t from 0 to π/2 in steps of"
                                + " 1/max(a, b)",
                        "no step along the ellipse is longer than one pixel",
                        "two sines and two roundings per pixel",
                        "lights pixels beside the nearest ones and two in a column",
                        "the parametric equation of the ellipse"),
                new ParametricEllipse());
    }

    private static Method<EllipseRasterizer> bresenham() {
        return new Method<>(
                "bresenham",
                new About(
                        "F(u, v) = 4·(b²·u² + a²·v² − a²·b²) at the middles between the three"
                                + " candidates",
                        "the pixel is the nearest one in its column or in its row",
                        "up to eight integer additions and four comparisons per pixel of a"
                                + " quadrant",
                        "none known for half-axes up to 2¹⁹; larger ones are refused",
                        "after J. E. Bresenham, A linear algorithm for incremental digital"
                                + " display of circular arcs, CACM 20(2), 1977"),
                new BresenhamEllipse());
    }

    private static Method<EllipseRasterizer> midpoint() {
        return new Method<>(
                "midpoint",
                new About(
                        "F(u, v − ½) ≥ 0 lowers the row of a column, F(u + ½, v) < 0 moves the"
                                + " column of a row on",
                        "the sign of F tells on which side of the middle the ellipse passes",
                        "one or two integer additions and comparisons per pixel of a quadrant",
                        "none known for half-axes up to 2¹⁹; larger ones are refused",
                        "M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a"
                                + " digital plotter, Computer Journal 10(3), 1967"),
                new MidpointEllipse());
    }
}
