package rasterlab.engine.circle;

import java.util.List;
import rasterlab.contract.CircleRasterizer;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Method.About;

/** The methods that draw a circle, in teaching order. */
final class CircleMethods {
    private CircleMethods() {}

    static List<Method<CircleRasterizer>> all() {
        return List.of(parametric(), bresenham(), midpoint());
    }

    private static Method<CircleRasterizer> parametric() {
        return new Method<>(
                "parametric",
                new About(
                        "u = r·sin t, v = r·cos t, both rounded; t from 0 to π/4 in steps of 1/r",
                        "no step along the circle is longer than one pixel",
                        "two sines and two roundings per pixel",
                        "lights pixels beside the nearest ones and two in a column",
                        "the parametric equation of the circle"),
                new ParametricCircle());
    }

    private static Method<CircleRasterizer> bresenham() {
        return new Method<>(
                "bresenham",
                new About(
                        "Δ = (u + 1)² + (v − 1)² − r² of the diagonal pixel; Δ < 0: side or"
                                + " diagonal, Δ > 0: diagonal or down, by the smaller |u² + v² − r²|",
                        "Δ is the diagonal pixel's distance from the circle in squares",
                        "two or three integer additions and two comparisons per pixel of a"
                                + " quadrant",
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
                        "one or two integer additions and one comparison per pixel of an octant",
                        "none known for any int radius",
                        "M. L. V. Pitteway, Algorithm for drawing ellipses or hyperbolae with a"
                                + " digital plotter, Computer Journal 10(3), 1967"),
                new MidpointCircle());
    }
}
