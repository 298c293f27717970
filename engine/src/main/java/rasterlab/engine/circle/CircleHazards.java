package rasterlab.engine.circle;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;

import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Circles on which methods fail, with what each method is known to make of them. */
final class CircleHazards {
    private CircleHazards() {}

    static List<Hazard<Circle>> all() {
        return List.of(
                hazard(
                        "radius-0",
                        "A circle without extent is one pixel.",
                        new Circle(5, 3, 0),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "radius-1",
                        "Four pixels; a walk that mirrors carelessly sends some twice.",
                        new Circle(5, 3, 1),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "corner",
                        "A pixel on the diagonal belongs to two octants.",
                        new Circle(0, 0, 4),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "crowded-columns",
                        "A rounded point of the circle is not always the nearest pixel of its column.",
                        new Circle(0, 0, 30),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "squares-beyond-int",
                        "r² does not fit into an int.",
                        new Circle(0, 0, 50_000),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "at-the-edge",
                        "The leftmost pixel is the last column an int can name.",
                        new Circle(Integer.MIN_VALUE + 9, 0, 9),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "beyond-the-edge",
                        "The circle would leave the range of int.",
                        new Circle(Integer.MAX_VALUE - 8, 0, 9),
                        REFUSED,
                        REFUSED,
                        REFUSED),
                hazard(
                        "negative-radius",
                        "There is no such circle.",
                        new Circle(0, 0, -1),
                        REFUSED,
                        REFUSED,
                        REFUSED));
    }

    private static Hazard<Circle> hazard(
            String name,
            String description,
            Circle input,
            Verdict.Kind parametric,
            Verdict.Kind bresenham,
            Verdict.Kind midpoint) {
        return new Hazard<>(
                name,
                description,
                input,
                Map.of("parametric", parametric, "bresenham", bresenham, "midpoint", midpoint));
    }
}
