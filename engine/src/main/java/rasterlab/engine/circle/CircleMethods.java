package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.CircleRasterizer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that draw a circle, in teaching order. */
final class CircleMethods {
    private CircleMethods() {}

    static List<Method<CircleRasterizer>> all() {
        return List.of(parametric(), bresenhamTextbook(), bresenham(), midpoint());
    }

    private static Method<CircleRasterizer> parametric() {
        return new Method<>(
                "parametric",
                new About(
                        "u = r·sin t, v = r·cos t, both rounded; t from 0 to π/4 in steps of 1/r",
                        "no step along the circle is longer than one pixel",
                        "two sines, two multiplications, a division and two roundings per step",
                        "lights pixels beside the nearest ones and two in a column",
                        "the parametric equation of the circle"),
                new ParametricCircle());
    }

    private static Method<CircleRasterizer> bresenhamTextbook() {
        return new Method<>(
                "bresenham-textbook",
                new About(
                        "the nearest of the pixels to the side, diagonally and below by |√(u² + v²) −"
                                + " r|; u² + v² in 32 bits",
                        "none from r = 46,341 on, where the squares overflow",
                        "six multiplications, eight additions, three square roots and three"
                                + " comparisons per pixel of an octant",
                        "overflow of u² + v² from r = 46,341 on; pixels on axes and diagonals are"
                                + " sent twice, that of radius 0 eight times",
                        "article \"Coordinate systems: world, object, observer and screen\", section on"
                                + " circles and ellipses, fig. 7"),
                new BresenhamTextbookCircle());
    }

    private static Method<CircleRasterizer> bresenham() {
        return new Method<>(
                "bresenham",
                new About(
                        "Δ = (u + 1)² + (v − 1)² − r² of the diagonal pixel; Δ < 0: side or"
                                + " diagonal, Δ > 0: diagonal or down, by the smaller |u² + v² − r²|",
                        "Δ is the diagonal pixel's distance from the circle in squares",
                        "two integer additions and two comparisons per pixel of a quadrant, two"
                                + " additions more for a step aside and for one down",
                        "none known for any int radius",
                        "J. E. Bresenham, A linear algorithm for incremental digital display of"
                                + " circular arcs, CACM 20(2), 1977"),
                new BresenhamCircle());
    }

    private static Method<CircleRasterizer> midpoint() {
        return new Method<>(
                "midpoint",
                new About(
                        "d = (u + 1)² + v² − v − r²; the row stays when d < 0",
                        "the sign of d tells on which side of the middle M = (u + 1, v − ½) the"
                                + " circle passes",
                        "two integer additions and one comparison per pixel of an octant, two"
                                + " additions more for a step down",
                        "none known for any int radius",
                        "M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a"
                                + " digital plotter, Computer Journal 10(3), 1967"),
                new MidpointCircle());
    }
}
