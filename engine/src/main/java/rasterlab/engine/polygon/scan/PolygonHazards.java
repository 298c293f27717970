package rasterlab.engine.polygon.scan;

import static rasterlab.contract.FillRule.EVEN_ODD;
import static rasterlab.contract.FillRule.NON_ZERO;
import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.contract.FillRule;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Polygons on which methods fail, with what each method is known to make of them. */
final class PolygonHazards {
    private PolygonHazards() {}

    static List<Hazard<PolygonTask>> all() {
        return Stream.of(ties(), crossings(), limits()).flatMap(List::stream).toList();
    }

    private static List<Hazard<PolygonTask>> ties() {
        return List.of(
                hazard(
                        "corners-on-centres",
                        PolygonTask.of(EVEN_ODD, 12, 12, 2, 2, 8, 2, 8, 8, 2, 8),
                        DEGRADED),
                hazard(
                        "corner-in-a-row",
                        PolygonTask.of(EVEN_ODD, 20, 12, 2, 1, 12, 5, 2, 9),
                        DEGRADED),
                hazard(
                        "corner-on-the-left",
                        PolygonTask.of(EVEN_ODD, 20, 12, 12, 1, 2, 5, 12, 9),
                        DEGRADED),
                hazard(
                        "valley-in-a-row",
                        PolygonTask.of(EVEN_ODD, 24, 12, 2, 10, 6, 1, 11, 5, 16, 1, 20, 10),
                        DEGRADED),
                hazard(
                        "rows-from-the-top",
                        PolygonTask.of(EVEN_ODD, 16, 12, 7.5, 10.5, 2.5, 5.3, 8.2, 1.4, 13.1, 6.2),
                        DEGRADED),
                hazard(
                        "level-edges",
                        PolygonTask.of(EVEN_ODD, 16, 12, 1, 1, 5, 1, 5, 4, 10, 4, 10, 8, 1, 8),
                        DEGRADED));
    }

    private static List<Hazard<PolygonTask>> crossings() {
        return List.of(
                hazard("star-non-zero", star(NON_ZERO), WRONG),
                hazard("star-even-odd", star(EVEN_ODD), DEGRADED),
                hazard(
                        "hair-beside-centres",
                        PolygonTask.of(EVEN_ODD, 12, 12, 0.1, 0.1, 9.1, 9.1 + 0x1p-49, 0.1, 9),
                        DEGRADED),
                hazard("slit", PolygonTask.of(EVEN_ODD, 40, 12, 0, 0.4, 39, 7.2, 39, 7.4), WRONG));
    }

    private static List<Hazard<PolygonTask>> limits() {
        return List.of(
                hazard("no-area", PolygonTask.of(EVEN_ODD, 12, 12, 1, 1, 9, 9, 5, 5), WRONG),
                hazard("two-corners", PolygonTask.of(NON_ZERO, 12, 12, 1, 1, 9, 4), WRONG),
                hazard("outside", PolygonTask.of(EVEN_ODD, 12, 12, 30, 1, 50, 5, 30, 9), EXACT),
                hazard(
                        "left-of-the-picture",
                        PolygonTask.of(EVEN_ODD, 12, 12, -6.3, 1.2, 7.4, 2.1, 5.2, 10.4, -4.1, 9.3),
                        DEGRADED),
                hazard(
                        "far-corners",
                        PolygonTask.of(
                                EVEN_ODD, 40, 40, -1e20, -1e20, 1e20, 1e20, -1e20, 1e20 + 1e5),
                        WRONG),
                hazard(
                        "no-number",
                        PolygonTask.of(EVEN_ODD, 12, 12, 1, 1, Double.NaN, 5, 1, 9),
                        REFUSED,
                        REFUSED),
                hazard(
                        "beyond-the-range",
                        PolygonTask.of(EVEN_ODD, 12, 12, 1, 1, Double.MAX_VALUE, 5, 1, 9),
                        REFUSED,
                        REFUSED));
    }

    private static PolygonTask star(FillRule rule) {
        var corners = new double[10];
        for (int i = 0; i < 5; i++) {
            corners[2 * i] = 20 + 18.3 * StrictMath.sin(2 * i * 2 * Math.PI / 5);
            corners[2 * i + 1] = 20.2 - 18.3 * StrictMath.cos(2 * i * 2 * Math.PI / 5);
        }
        return PolygonTask.of(rule, 40, 40, corners);
    }

    private static Hazard<PolygonTask> hazard(String name, PolygonTask input, Verdict.Kind naive) {
        return hazard(name, input, naive, EXACT);
    }

    private static Hazard<PolygonTask> hazard(
            String name, PolygonTask input, Verdict.Kind naive, Verdict.Kind others) {
        return new Hazard<>(
                name, input, Map.of("naive", naive, "scanline", others, "edge-function", others));
    }
}
