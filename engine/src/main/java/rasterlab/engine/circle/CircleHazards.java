package rasterlab.engine.circle;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/** Circles on which methods fail, with what each method is known to make of them. */
final class CircleHazards {
    private static final String PARAMETRIC = "parametric";
    private static final String TEXTBOOK = "bresenham-textbook";

    private CircleHazards() {}

    static List<Hazard<Circle>> all() {
        return List.of(
                hazard(
                        "radius-0",
                        "A circle without extent is one pixel.",
                        new Circle(5, 3, 0),
                        Map.of(TEXTBOOK, DEGRADED)),
                hazard(
                        "radius-1",
                        "Four pixels; a walk that mirrors carelessly sends some twice.",
                        new Circle(5, 3, 1),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "off-the-diagonal",
                        "The centre's column is not its row.",
                        new Circle(20, -7, 6),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "corner",
                        "A pixel on the diagonal belongs to two octants.",
                        new Circle(0, 0, 4),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "crowded-columns",
                        "A rounded point of the circle is not always the nearest pixel of its column.",
                        new Circle(0, 0, 30),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "squares-beyond-int",
                        "r² does not fit into an int.",
                        new Circle(0, 0, 50_000),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, WRONG)),
                hazard(
                        "at-the-edge",
                        "The leftmost pixel is the last column an int can name.",
                        new Circle(Integer.MIN_VALUE + 9, 0, 9),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "beyond-the-edge",
                        "The circle would leave the range of int.",
                        new Circle(Integer.MAX_VALUE - 8, 0, 9),
                        refusedByAll()),
                hazard(
                        "negative-radius",
                        "There is no such circle.",
                        new Circle(0, 0, -1),
                        refusedByAll()));
    }

    /** Methods that are not named are exact. */
    private static Hazard<Circle> hazard(
            String name, String description, Circle input, Map<String, Verdict.Kind> failing) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (var method : CircleMethods.all()) recorded.put(method.name(), EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, description, input, recorded);
    }

    private static Map<String, Verdict.Kind> refusedByAll() {
        return CircleMethods.all().stream().collect(Collectors.toMap(Method::name, m -> REFUSED));
    }
}
