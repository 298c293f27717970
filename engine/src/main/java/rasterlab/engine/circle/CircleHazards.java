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
                hazard("radius-0", new Circle(5, 3, 0), Map.of(TEXTBOOK, DEGRADED)),
                hazard(
                        "radius-1",
                        new Circle(5, 3, 1),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "off-the-diagonal",
                        new Circle(20, -7, 6),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "corner",
                        new Circle(0, 0, 4),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "crowded-columns",
                        new Circle(0, 0, 30),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard(
                        "squares-beyond-int",
                        new Circle(0, 0, 50_000),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, WRONG)),
                hazard(
                        "at-the-edge",
                        new Circle(Integer.MIN_VALUE + 9, 0, 9),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, DEGRADED)),
                hazard("beyond-the-edge", new Circle(Integer.MAX_VALUE - 8, 0, 9), refusedByAll()),
                hazard("negative-radius", new Circle(0, 0, -1), refusedByAll()));
    }

    /** Methods that are not named are exact. */
    private static Hazard<Circle> hazard(
            String name, Circle input, Map<String, Verdict.Kind> failing) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (var method : CircleMethods.all()) recorded.put(method.name(), EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, input, recorded);
    }

    private static Map<String, Verdict.Kind> refusedByAll() {
        return CircleMethods.all().stream().collect(Collectors.toMap(Method::name, m -> REFUSED));
    }
}
