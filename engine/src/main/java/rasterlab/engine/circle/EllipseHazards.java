package rasterlab.engine.circle;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.ENDLESS;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;

/** Ellipses on which methods fail, with what each method is known to make of them. */
final class EllipseHazards {
    private static final String PARAMETRIC = "parametric";
    private static final String TEXTBOOK = "bresenham-textbook";

    private EllipseHazards() {}

    static List<Hazard<Ellipse>> all() {
        return Stream.of(nearlyStraight(), whereColumnsGiveWay(), refused())
                .flatMap(List::stream)
                .toList();
    }

    private static List<Hazard<Ellipse>> nearlyStraight() {
        return List.of(
                hazard("point", new Ellipse(5, 3, 0, 0), Map.of()),
                hazard("flat-line", new Ellipse(5, 3, 9, 0), Map.of(TEXTBOOK, WRONG)),
                hazard("upright-line", new Ellipse(5, 3, 0, 9), Map.of()),
                hazard("very-flat", new Ellipse(0, 0, 100, 1), Map.of(TEXTBOOK, WRONG)),
                hazard("very-tall", new Ellipse(0, 0, 1, 100), Map.of()));
    }

    private static List<Hazard<Ellipse>> whereColumnsGiveWay() {
        return List.of(
                hazard("corner", new Ellipse(0, 0, 10, 18), Map.of(PARAMETRIC, DEGRADED)),
                hazard(
                        "corner-through-a-pixel",
                        new Ellipse(0, 0, 3, 2),
                        Map.of(PARAMETRIC, DEGRADED)),
                hazard(
                        "products-beyond-int",
                        new Ellipse(0, 0, 1500, 1000),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, WRONG)),
                hazard(
                        "products-beyond-long",
                        new Ellipse(0, 0, 60_000, 60_001),
                        Map.of(PARAMETRIC, DEGRADED, TEXTBOOK, ENDLESS)));
    }

    private static List<Hazard<Ellipse>> refused() {
        return List.of(
                hazard(
                        "beyond-the-edge",
                        new Ellipse(0, Integer.MIN_VALUE + 4, 9, 5),
                        refusedByAll()),
                hazard(
                        "too-large",
                        new Ellipse(0, 0, 1 << 20, 7),
                        Map.of(
                                PARAMETRIC,
                                REFUSED,
                                TEXTBOOK,
                                WRONG,
                                "bresenham",
                                REFUSED,
                                "midpoint",
                                REFUSED)),
                hazard("negative-radius", new Ellipse(0, 0, 4, -1), refusedByAll()));
    }

    /** Methods that are not named are exact. */
    private static Hazard<Ellipse> hazard(
            String name, Ellipse input, Map<String, Verdict.Kind> failing) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (var method : EllipseMethods.all()) recorded.put(method.name(), EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, input, recorded);
    }

    private static Map<String, Verdict.Kind> refusedByAll() {
        return EllipseMethods.all().stream().collect(Collectors.toMap(Method::name, m -> REFUSED));
    }
}
