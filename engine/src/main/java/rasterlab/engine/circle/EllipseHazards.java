package rasterlab.engine.circle;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Ellipses on which methods fail, with what each method is known to make of them. */
final class EllipseHazards {
    private EllipseHazards() {}

    static List<Hazard<Ellipse>> all() {
        return Stream.of(nearlyStraight(), whereColumnsGiveWay(), refused())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<Ellipse>> nearlyStraight() {
        return List.of(
                hazard(
                        "point",
                        "Without extent it is one pixel.",
                        new Ellipse(5, 3, 0, 0),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "flat-line",
                        "A half-axis of 0 leaves a straight line.",
                        new Ellipse(5, 3, 9, 0),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "upright-line",
                        "The same along a column.",
                        new Ellipse(5, 3, 0, 9),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "very-flat",
                        "The curve reaches row 0 before its end: the tip is lost easily.",
                        new Ellipse(0, 0, 100, 1),
                        EXACT,
                        EXACT,
                        EXACT),
                hazard(
                        "very-tall",
                        "The same along columns.",
                        new Ellipse(0, 0, 1, 100),
                        EXACT,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<Ellipse>> whereColumnsGiveWay() {
        return List.of(
                hazard(
                        "corner",
                        "Where columns give way to rows a pixel is lost easily.",
                        new Ellipse(0, 0, 10, 18),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "corner-through-a-pixel",
                        "The curve goes through a pixel centre there.",
                        new Ellipse(0, 0, 3, 2),
                        DEGRADED,
                        EXACT,
                        EXACT),
                hazard(
                        "products-beyond-long",
                        "a²·b² does not fit into a long.",
                        new Ellipse(0, 0, 60_000, 60_001),
                        DEGRADED,
                        EXACT,
                        EXACT));
    }

    private static List<Hazard<Ellipse>> refused() {
        return List.of(
                hazard(
                        "beyond-the-edge",
                        "The ellipse would leave the range of int.",
                        new Ellipse(0, Integer.MIN_VALUE + 4, 9, 5),
                        REFUSED,
                        REFUSED,
                        REFUSED),
                hazard(
                        "too-large",
                        "Half-axes whose decisions would not fit into a long.",
                        new Ellipse(0, 0, 1 << 20, 7),
                        REFUSED,
                        REFUSED,
                        REFUSED),
                hazard(
                        "negative-radius",
                        "There is no such ellipse.",
                        new Ellipse(0, 0, 4, -1),
                        REFUSED,
                        REFUSED,
                        REFUSED));
    }

    private static Hazard<Ellipse> hazard(
            String name,
            String description,
            Ellipse input,
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
