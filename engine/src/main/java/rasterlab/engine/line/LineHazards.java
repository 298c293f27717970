package rasterlab.engine.line;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.ENDLESS;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Segments on which methods fail, with what each method is known to make of them. */
final class LineHazards {
    private static final String NAIVE = "naive-textbook";
    private static final String FLOAT = "dda-float";
    private static final String FIRST = "bresenham-first-textbook";
    private static final String PASCAL = "bresenham-pascal-textbook";
    private static final String FULL = "bresenham-textbook";
    private static final String CLIP = "clip-first-textbook";

    private LineHazards() {}

    static List<Hazard<Segment>> all() {
        return Stream.of(directions(), windows(), distances()).flatMap(List::stream).toList();
    }

    private static List<Hazard<Segment>> directions() {
        return List.of(
                hazard("first-octant", new Segment(0, 0, 11, 4), Map.of()),
                hazard("both-ends", new Segment(2, 1, 8, 3), Map.of()),
                hazard("ties", new Segment(0, 0, 16, 8), Map.of(NAIVE, DEGRADED, PASCAL, DEGRADED)),
                hazard(
                        "swapped-ends",
                        new Segment(0, 16, 8, 0).reversed(),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG, FULL, DEGRADED)),
                hazard(
                        "steep",
                        new Segment(0, 0, 3, 13),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG)),
                hazard("upward", new Segment(0, 4, 11, 0), Map.of(FIRST, WRONG, PASCAL, WRONG)),
                hazard(
                        "leftward",
                        new Segment(12, 10, 0, 0),
                        Map.of(
                                NAIVE, WRONG, FLOAT, DEGRADED, FIRST, WRONG, PASCAL, DEGRADED, FULL,
                                WRONG)),
                hazard(
                        "steep-upward",
                        new Segment(0, 13, 3, 0),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG, FULL, DEGRADED)),
                hazard(
                        "vertical",
                        new Segment(4, 1, 4, 9),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG)),
                hazard(
                        "single-point",
                        new Segment(5, 3, 5, 3),
                        Map.of(NAIVE, WRONG, FULL, DEGRADED)));
    }

    /** The pixels shown must be those that the whole line lights there. */
    private static List<Hazard<Segment>> windows() {
        return List.of(
                hazard(
                        "window",
                        new Segment(-20, -3, 41, 14).in(new PixelWindow(0, 0, 20, 20)),
                        Map.of(CLIP, DEGRADED)),
                hazard(
                        "window-grazed",
                        new Segment(0, 0, 61, 1).in(new PixelWindow(20, 1, 40, 9)),
                        Map.of(CLIP, WRONG)));
    }

    private static List<Hazard<Segment>> distances() {
        return List.of(
                hazard("long", new Segment(0, 0, 19_999, 12_345), Map.of(FLOAT, DEGRADED)),
                hazard(
                        "products-beyond-int",
                        new Segment(0, 0, 200_000, 30_011),
                        Map.of(FLOAT, WRONG)),
                hazard(
                        "far-away",
                        new Segment(20_000_001, 30_000_003, 20_000_041, 30_000_020),
                        Map.of(NAIVE, DEGRADED, FLOAT, WRONG, PASCAL, DEGRADED)),
                hazard(
                        "beyond-2-24",
                        new Segment(-20_000_000, -1_000_000, 13_554_432, 11_345_678),
                        Map.of("naive", REFUSED, FLOAT, WRONG, "dda", REFUSED, "wu", REFUSED)),
                hazard(
                        "beyond-2-30",
                        new Segment(-1_200_000_000, -1_100_000_000, 1_200_000_000, 1_090_000_000),
                        beyondInt()),
                hazard(
                        "last-column",
                        new Segment(Integer.MAX_VALUE - 7, 5, Integer.MAX_VALUE, 8),
                        Map.of(NAIVE, ENDLESS, FLOAT, WRONG, FIRST, ENDLESS, FULL, ENDLESS)));
    }

    private static Map<String, Verdict.Kind> beyondInt() {
        return Map.of(
                NAIVE, WRONG, "naive", REFUSED, FLOAT, WRONG, "dda", REFUSED, FIRST, WRONG, PASCAL,
                WRONG, FULL, WRONG, "wu", REFUSED);
    }

    /** Methods that are not named are exact. */
    private static Hazard<Segment> hazard(
            String name, Segment segment, Map<String, Verdict.Kind> failing) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (var method : LineMethods.all()) recorded.put(method.name(), EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, segment, recorded);
    }
}
