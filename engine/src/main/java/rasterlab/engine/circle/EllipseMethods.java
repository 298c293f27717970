package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that draw an ellipse, in teaching order. */
final class EllipseMethods {
    private EllipseMethods() {}

    static List<Method<EllipseRasterizer>> all() {
        return List.of(parametric(), bresenhamTextbook(), bresenham(), midpoint());
    }

    private static Method<EllipseRasterizer> parametric() {
        return new Method<>(
                "parametric",
                new About(
                        "u = a·sin t, v = b·cos t, both rounded; t from 0 to π/2 in steps of"
                                + " 1/max(a, b)",
                        "no step along the ellipse is longer than one pixel",
                        "two sines, two multiplications, a division and two roundings per step",
                        "lights pixels beside the nearest ones and two in a column",
                        "the parametric equation of the ellipse"),
                new ParametricEllipse());
    }

    private static Method<EllipseRasterizer> bresenhamTextbook() {
        return new Method<>(
                "bresenham-textbook",
                new About(
                        "F(u, v) = 4·(b²·u² + a²·v² − a²·b²) at the middles between the three"
                                + " candidates, in 32 bits, down to the first pixel of row 0",
                        "none from half-axes of about 400 on, where the products overflow",
                        "six multiplications, eight additions and four comparisons per pixel of a"
                                + " quadrant",
                        "loses the tip of a flat ellipse and all but the centre of one without"
                                + " height; products overflow from half-axes of about 400 on",
                        "article \"Coordinate systems: world, object, observer and screen\", section on"
                                + " circles and ellipses, fig. 7"),
                new BresenhamTextbookEllipse());
    }

    private static Method<EllipseRasterizer> bresenham() {
        return new Method<>(
                "bresenham",
                new About(
                        "F(u, v) = 4·(b²·u² + a²·v² − a²·b²) at the middles between the three"
                                + " candidates",
                        "the pixel is the nearest one in its column or in its row",
                        "four integer additions and four comparisons per pixel of a quadrant, four"
                                + " additions more for a step aside and for one down",
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
                        "two integer additions for each step aside and for each one down, and one"
                                + " or two comparisons per pixel of a quadrant",
                        "none known for half-axes up to 2¹⁹; larger ones are refused",
                        "M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a"
                                + " digital plotter, Computer Journal 10(3), 1967"),
                new MidpointEllipse());
    }
}
