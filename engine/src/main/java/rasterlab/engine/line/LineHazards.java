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
                hazard(
                        "first-octant",
                        "The slope and direction that the first versions are made for.",
                        new Segment(0, 0, 11, 4),
                        Map.of()),
                hazard(
                        "both-ends",
                        "The pixels of both ends are lit, and none beyond them.",
                        new Segment(2, 1, 8, 3),
                        Map.of()),
                hazard(
                        "ties",
                        "The line passes midway between two pixels in every second column.",
                        new Segment(0, 0, 16, 8),
                        Map.of(NAIVE, DEGRADED, PASCAL, DEGRADED)),
                hazard(
                        "swapped-ends",
                        "A line full of ties drawn from its far end must light the same pixels.",
                        new Segment(0, 16, 8, 0).reversed(),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG, FULL, DEGRADED)),
                hazard(
                        "steep",
                        "Above 45° there are more rows than columns.",
                        new Segment(0, 0, 3, 13),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG)),
                hazard(
                        "upward",
                        "To the right, and the rows have to be counted down.",
                        new Segment(0, 4, 11, 0),
                        Map.of(FIRST, WRONG, PASCAL, WRONG)),
                hazard(
                        "leftward",
                        "The second end lies to the left of the first.",
                        new Segment(12, 10, 0, 0),
                        Map.of(
                                NAIVE, WRONG, FLOAT, DEGRADED, FIRST, WRONG, PASCAL, DEGRADED, FULL,
                                WRONG)),
                hazard(
                        "steep-upward",
                        "Steep, and the rows have to be counted down.",
                        new Segment(0, 13, 3, 0),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG, FULL, DEGRADED)),
                hazard(
                        "vertical",
                        "There is no slope: the columns do not differ.",
                        new Segment(4, 1, 4, 9),
                        Map.of(NAIVE, WRONG, FIRST, WRONG, PASCAL, WRONG)),
                hazard(
                        "single-point",
                        "Both ends are the same pixel.",
                        new Segment(5, 3, 5, 3),
                        Map.of(NAIVE, WRONG, FULL, DEGRADED)));
    }

    /** The pixels shown must be those that the whole line lights there. */
    private static List<Hazard<Segment>> windows() {
        return List.of(
                hazard(
                        "window",
                        "The line enters and leaves a window; between rounded ends it would turn.",
                        new Segment(-20, -3, 41, 14).in(new PixelWindow(0, 0, 20, 20)),
                        Map.of(CLIP, DEGRADED)),
                hazard(
                        "window-grazed",
                        "The exact line passes above the window, by less than half a pixel: its"
                                + " pixels lie inside.",
                        new Segment(0, 0, 61, 1).in(new PixelWindow(20, 1, 40, 9)),
                        Map.of(CLIP, WRONG)));
    }

    private static List<Hazard<Segment>> distances() {
        return List.of(
                hazard(
                        "long",
                        "Small errors have twenty thousand steps to add up.",
                        new Segment(0, 0, 19_999, 12_345),
                        Map.of(FLOAT, DEGRADED)),
                hazard(
                        "products-beyond-int",
                        "After a third of the way a step times the height no longer fits in an int.",
                        new Segment(0, 0, 200_000, 30_011),
                        Map.of(FLOAT, WRONG)),
                hazard(
                        "far-away",
                        "Coordinates beyond 2²⁴, where not every pixel has a float.",
                        new Segment(20_000_001, 30_000_003, 20_000_041, 30_000_020),
                        Map.of(NAIVE, DEGRADED, FLOAT, WRONG, PASCAL, DEGRADED)),
                hazard(
                        "beyond-2-24",
                        "Twice as many pixels as a float counts; the last are looked at, too.",
                        new Segment(-20_000_000, -1_000_000, 13_554_432, 11_345_678),
                        Map.of("naive", REFUSED, FLOAT, WRONG, "dda", REFUSED, "wu", REFUSED)),
                hazard(
                        "beyond-2-30",
                        "Ends beyond ±2³⁰: differences and their doubles overflow an int.",
                        new Segment(-1_200_000_000, -1_100_000_000, 1_200_000_000, 1_090_000_000),
                        beyondInt()),
                hazard(
                        "last-column",
                        "The line ends in the last column an int can name, which no counter can"
                                + " pass.",
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
            String name, String description, Segment segment, Map<String, Verdict.Kind> failing) {
        var recorded = new HashMap<String, Verdict.Kind>();
        for (var method : LineMethods.all()) recorded.put(method.name(), EXACT);
        recorded.putAll(failing);
        return new Hazard<>(name, description, segment, recorded);
    }
}
