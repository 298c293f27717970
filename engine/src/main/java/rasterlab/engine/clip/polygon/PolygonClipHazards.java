package rasterlab.engine.clip.polygon;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Polygons on which methods fail, and what each method is known to make of them. */
final class PolygonClipHazards {
    private static final double[] TEN = PolygonInWindow.rectangle(0, 0, 10, 10);

    private PolygonClipHazards() {}

    static List<Hazard<PolygonInWindow>> all() {
        var all = new ArrayList<>(shapes());
        all.addAll(touching());
        all.addAll(improper());
        all.addAll(refused());
        return all;
    }

    /** Convex and not, in each place. */
    private static List<Hazard<PolygonInWindow>> shapes() {
        return List.of(
                hazard("convex", TEN, recorded(EXACT, EXACT, EXACT), "5 5, 15 8, 8 15"),
                hazard(
                        "two-pieces",
                        TEN,
                        recorded(DEGRADED, EXACT, DEGRADED),
                        "2 2, 14 2, 14 8, 2 8, 2 7, 13 7, 13 3, 2 3"),
                hazard(
                        "comb",
                        TEN,
                        recorded(DEGRADED, EXACT, DEGRADED),
                        "1 -3, 9 -3, 9 5, 8 5, 8 -2, 6 -2, 6 5, 5 5, 5 -2, 3 -2, 3 5, 1 5"),
                hazard(
                        "clockwise",
                        TEN,
                        recorded(DEGRADED, EXACT, DEGRADED),
                        "1 5, 3 5, 3 -2, 5 -2, 5 5, 6 5, 6 -2, 8 -2, 8 5, 9 5, 9 -3, 1 -3"),
                hazard("inside", TEN, recorded(EXACT, EXACT, EXACT), "2 2, 8 3, 5 8"),
                hazard("around", TEN, recorded(EXACT, EXACT, EXACT), "-5 -5, 20 -5, 20 20, -5 20"),
                hazard(
                        "outside-around-a-corner",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "-4 3, 3 -4, 2 -6, -6 2"),
                hazard(
                        "several-corners",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "-2 3, 3 -2, 7 -2, 12 3, 12 7, 7 12, 3 12, -2 7"));
    }

    /** Corners and edges on the rim. */
    private static List<Hazard<PolygonInWindow>> touching() {
        return List.of(
                hazard(
                        "same-as-window",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "0 0, 10 0, 10 10, 0 10"),
                hazard(
                        "corners-on-sides",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "5 0, 10 5, 5 10, 0 5"),
                hazard(
                        "edges-along-sides",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "0 2, 4 2, 4 0, 8 0, 8 -3, 10 -3, 10 10, 12 10, 12 12, 0 12"),
                hazard("touches-from-inside", TEN, recorded(EXACT, EXACT, EXACT), "2 2, 10 5, 2 8"),
                hazard(
                        "hollow-touches-from-inside",
                        TEN,
                        recorded(DEGRADED, EXACT, DEGRADED),
                        "-2 -2, 12 -2, 12 12, 5 12, 10 5, 5 11, -2 11"),
                hazard(
                        "touches-from-outside",
                        TEN,
                        recorded(EXACT, EXACT, DEGRADED),
                        "10 5, 14 2, 14 8"),
                hazard(
                        "shares-a-side-outside",
                        TEN,
                        recorded(EXACT, EXACT, DEGRADED),
                        "10 2, 14 2, 14 8, 10 8"),
                hazard(
                        "through-window-corners",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "-5 5, 5 -5, 15 5, 5 15"),
                hazard(
                        "straight-corners",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "-2 5, 5 5, 5 5, 12 5, 12 7, 6 7, -2 7"));
    }

    /** Other windows, extreme numbers, and what is no polygon. */
    private static List<Hazard<PolygonInWindow>> improper() {
        return List.of(
                hazard(
                        "convex-window",
                        new double[] {0, 0, 8, -2, 12, 4, 9, 11, 1, 9},
                        recorded(DEGRADED, EXACT, DEGRADED),
                        "-4 4, 14 3, 14 5, -2 6, 14 7, 14 9, -4 8"),
                hazard(
                        "far-corners",
                        TEN,
                        recorded(EXACT, EXACT, WRONG),
                        "-1e30 -1e30, 1e30 0, 0 1e30"),
                hazard(
                        "huge-window",
                        PolygonInWindow.rectangle(0, 0, 1e200, 1e200),
                        recorded(EXACT, EXACT, EXACT),
                        "1e199 1e199, 9e199 1e199, 5e199 9e199"),
                hazard(
                        "window-one-double-high",
                        PolygonInWindow.rectangle(0, 0, 1, Double.MIN_VALUE),
                        recorded(EXACT, EXACT, WRONG),
                        "0 0, 2 4.9e-324, 0 1"),
                hazard("sliver", TEN, recorded(EXACT, EXACT, EXACT), "1 1, 9 9, 5 5.0000000000001"),
                hazard(
                        "minus-zero",
                        TEN,
                        recorded(EXACT, EXACT, EXACT),
                        "-0.0 -0.0, 7 -0.0, 7 12, -0.0 5"),
                hazard(
                        "straight-by-rounding",
                        PolygonInWindow.rectangle(0, 0, 7, 2),
                        recorded(EXACT, EXACT, EXACT),
                        "8.875 2, 3.8000000000000003 1, 6.3375 1.5"));
    }

    private static List<Hazard<PolygonInWindow>> refused() {
        return List.of(
                hazard(
                        "self-intersecting",
                        TEN,
                        recorded(REFUSED, REFUSED, WRONG),
                        "2 2, 12 8, 12 2, 2 8"),
                hazard(
                        "corner-on-an-edge",
                        TEN,
                        recorded(REFUSED, REFUSED, WRONG),
                        "2 2, 12 2, 12 8, 7 2, 2 8"),
                hazard("not-a-number", TEN, recorded(REFUSED, REFUSED, WRONG), "2 2, NaN 2, 5 8"),
                hazard("two-corners", TEN, recorded(REFUSED, REFUSED, DEGRADED), "2 2, 8 8"),
                hazard(
                        "window-not-convex",
                        new double[] {0, 0, 10, 0, 5, 3, 5, 10},
                        recorded(REFUSED, REFUSED, WRONG),
                        "2 2, 8 2, 5 8"));
    }

    private static Hazard<PolygonInWindow> hazard(
            String name, double[] window, Map<String, Verdict.Kind> recorded, String subject) {
        return new Hazard<>(name, new PolygonInWindow(window, corners(subject)), recorded);
    }

    private static double[] corners(String text) {
        return Arrays.stream(text.split("[, ]+")).mapToDouble(Double::parseDouble).toArray();
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind sutherlandHodgman, Verdict.Kind weilerAtherton, Verdict.Kind textbook) {
        return Map.of(
                "sutherland-hodgman",
                sutherlandHodgman,
                "weiler-atherton",
                weilerAtherton,
                "sutherland-hodgman-textbook",
                textbook);
    }
}
