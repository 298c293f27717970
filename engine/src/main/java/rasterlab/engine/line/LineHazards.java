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
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Segments on which methods fail, with what each method is known to make of them. */
final class LineHazards {
    private LineHazards() {}

    static List<Hazard<Segment>> all() {
        return Stream.concat(directions().stream(), distances().stream()).toList();
    }

    private static List<Hazard<Segment>> directions() {
        return List.of(
                hazard(
                        "first-octant",
                        "The slope and direction that the first versions are made for.",
                        new Segment(0, 0, 11, 4),
                        recorded(EXACT, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "ties",
                        "The line passes midway between two pixels in every second column.",
                        new Segment(0, 0, 16, 8),
                        recorded(DEGRADED, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "swapped-ends",
                        "A line full of ties drawn from its far end must light the same pixels.",
                        new Segment(0, 16, 8, 0).reversed(),
                        recorded(WRONG, EXACT, EXACT, EXACT, DEGRADED, EXACT, EXACT, EXACT)),
                hazard(
                        "steep",
                        "Above 45° there are more rows than columns.",
                        new Segment(0, 0, 3, 13),
                        recorded(WRONG, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "leftward",
                        "The second end lies to the left of the first.",
                        new Segment(12, 10, 0, 0),
                        recorded(WRONG, EXACT, DEGRADED, EXACT, WRONG, EXACT, EXACT, EXACT)),
                hazard(
                        "steep-upward",
                        "Steep, and the rows have to be counted down.",
                        new Segment(0, 13, 3, 0),
                        recorded(WRONG, EXACT, EXACT, EXACT, DEGRADED, EXACT, EXACT, EXACT)),
                hazard(
                        "vertical",
                        "There is no slope: the columns do not differ.",
                        new Segment(4, 1, 4, 9),
                        recorded(WRONG, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "single-point",
                        "Both ends are the same pixel.",
                        new Segment(5, 3, 5, 3),
                        recorded(WRONG, EXACT, EXACT, EXACT, DEGRADED, EXACT, EXACT, EXACT)));
    }

    private static List<Hazard<Segment>> distances() {
        return List.of(
                hazard(
                        "long",
                        "Small errors have twenty thousand steps to add up.",
                        new Segment(0, 0, 19_999, 12_345),
                        recorded(EXACT, EXACT, DEGRADED, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "far-away",
                        "Coordinates beyond 2²⁴, where not every pixel has a float.",
                        new Segment(20_000_001, 30_000_003, 20_000_041, 30_000_020),
                        recorded(DEGRADED, EXACT, WRONG, EXACT, EXACT, EXACT, EXACT, EXACT)),
                hazard(
                        "beyond-2-30",
                        "Ends beyond ±2³⁰: differences and their doubles overflow an int.",
                        new Segment(-1_200_000_000, -1_100_000_000, 1_200_000_000, 1_090_000_000),
                        recorded(WRONG, REFUSED, WRONG, REFUSED, WRONG, EXACT, EXACT, REFUSED)),
                hazard(
                        "last-column",
                        "The line ends in the last column an int can name, which no counter can"
                                + " pass.",
                        new Segment(Integer.MAX_VALUE - 7, 5, Integer.MAX_VALUE, 8),
                        recorded(ENDLESS, EXACT, WRONG, EXACT, ENDLESS, EXACT, EXACT, EXACT)));
    }

    private static Hazard<Segment> hazard(
            String name, String description, Segment segment, Map<String, Verdict.Kind> recorded) {
        return new Hazard<>(name, description, segment, recorded);
    }

    /**
     * @param kinds one for each method, in {@link LineMethods#all}'s order
     */
    private static Map<String, Verdict.Kind> recorded(Verdict.Kind... kinds) {
        var recorded = new HashMap<String, Verdict.Kind>();
        var methods = LineMethods.all();
        for (int i = 0; i < methods.size(); i++) recorded.put(methods.get(i).name(), kinds[i]);
        return recorded;
    }
}
