package rasterlab.engine.clip.segment;

import static rasterlab.engine.study.Verdict.Kind.ENDLESS;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Segments on which methods fail, and what each method is known to make of them. */
final class SegmentClipHazards {
    private static final ClipWindow TEN = new ClipWindow(0, 0, 10, 10);
    private static final double MOST = Double.MAX_VALUE;
    private static final double TINY = Double.MIN_VALUE;

    private SegmentClipHazards() {}

    static List<Hazard<SegmentsInWindow>> all() {
        var all = new ArrayList<>(ordinary());
        all.addAll(around());
        all.addAll(touching());
        all.addAll(extreme());
        all.addAll(vanishing());
        return all;
    }

    /** The mistakes that the listings make even in plain cases. */
    private static List<Hazard<SegmentsInWindow>> ordinary() {
        return List.of(
                hazard(
                        "inside-and-above",
                        TEN,
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        s(1, 2, 9, 8),
                        s(3, 5, 9, 17),
                        s(5, 15, 5, 5)),
                hazard(
                        "wholly-outside",
                        TEN,
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        s(-5, 2, -1, 8),
                        s(3, 12, 7, 15)),
                hazard(
                        "past-a-corner",
                        TEN,
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(-6, 4, 4, -6),
                        s(-4, 8, 3, 16)),
                hazard(
                        "shallow-slope",
                        TEN,
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(0, 2, 20, 8)),
                hazard(
                        "fractions",
                        TEN,
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        s(0.25, 0.5, 5.5, 11.75)));
    }

    /** Ends in the regions around the window, in whole numbers. */
    private static List<Hazard<SegmentsInWindow>> around() {
        return List.of(
                hazard("only-left", TEN, recorded(EXACT, ENDLESS, EXACT, EXACT), s(-5, 5, 5, 5)),
                hazard(
                        "ends-stay",
                        TEN,
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        s(0.1, 0.3, 0.7, 0.9),
                        s(9.7, 0.1, 0.3, 9.9)),
                hazard("only-below", TEN, recorded(EXACT, ENDLESS, EXACT, EXACT), s(5, -5, 5, 5)),
                hazard(
                        "below-and-left",
                        TEN,
                        recorded(WRONG, WRONG, EXACT, EXACT),
                        s(-2, -3, 8, 12)),
                hazard(
                        "through-the-window",
                        TEN,
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(-3, 4, 14, 7),
                        s(4, -3, 7, 14),
                        s(2, 18, 15, -4)),
                hazard(
                        "window-not-square",
                        new ClipWindow(0, 0, 20, 10),
                        recorded(WRONG, WRONG, EXACT, EXACT),
                        s(8, 1, 26, -4)),
                hazard(
                        "swapped-ends",
                        TEN,
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(14, 7, -3, 4),
                        s(15, -4, 2, 18)));
    }

    /** Where little or nothing is left. */
    private static List<Hazard<SegmentsInWindow>> touching() {
        return List.of(
                hazard(
                        "touches-a-corner",
                        TEN,
                        recorded(EXACT, ENDLESS, EXACT, EXACT),
                        s(-3, 3, 3, -3),
                        s(7, 13, 13, 7)),
                hazard(
                        "ends-at-a-corner",
                        TEN,
                        recorded(WRONG, EXACT, ENDLESS, EXACT),
                        s(-5, 21, 10, 10),
                        s(15, -8, 10, 10)),
                hazard(
                        "misses-a-corner-by-one-step",
                        TEN,
                        recorded(WRONG, ENDLESS, WRONG, EXACT),
                        s(-3, Math.nextDown(3.0), 3, -3),
                        s(7, Math.nextUp(13.0), 13, 7)),
                hazard(
                        "along-a-side",
                        TEN,
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(-4, 0, 4, 0),
                        s(10, 3, 10, 30),
                        s(12, 10, 20, 10)),
                hazard(
                        "single-points",
                        TEN,
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        s(5, 5, 5, 5),
                        s(10, 10, 10, 10),
                        s(11, 5, 11, 5)),
                hazard(
                        "window-without-area",
                        new ClipWindow(0, 5, 10, 5),
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(3, 0, 6, 10),
                        s(-5, 5, 15, 5),
                        s(-5, 0, 5, 4)),
                hazard(
                        "window-of-one-point",
                        new ClipWindow(5, 5, 5, 5),
                        recorded(WRONG, EXACT, EXACT, EXACT),
                        s(0, 0, 10, 10),
                        s(0, 0, 10, 11)));
    }

    /** Numbers at the limits of doubles and beyond. */
    private static List<Hazard<SegmentsInWindow>> extreme() {
        return List.of(
                hazard(
                        "ends-at-1e30",
                        TEN,
                        recorded(ENDLESS, ENDLESS, WRONG, EXACT),
                        s(-1e30, -1e30, 1e30, 1e30),
                        s(-1e30, 5, 1e30, 6),
                        s(-1e30, 3, 2e30, 3 + 1e15)),
                hazard(
                        "largest-doubles",
                        TEN,
                        recorded(EXACT, ENDLESS, WRONG, EXACT),
                        s(-MOST, -MOST, MOST, MOST),
                        s(-MOST, 4, MOST, 4)),
                hazard(
                        "smallest-doubles",
                        new ClipWindow(0, 0, 2 * TINY, 2 * TINY),
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(-TINY, TINY, 3 * TINY, TINY),
                        s(-TINY, 0, TINY, 2 * TINY)),
                hazard(
                        "far-window",
                        new ClipWindow(1e12, 1e12, 1e12 + 1, 1e12 + 1),
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(1e12 - 1, 1e12 + 0.25, 1e12 + 2, 1e12 + 0.75)),
                hazard(
                        "not-a-number",
                        TEN,
                        recorded(WRONG, WRONG, WRONG, REFUSED),
                        s(Double.NaN, 5, 5, 5)),
                hazard(
                        "infinite",
                        TEN,
                        recorded(WRONG, ENDLESS, WRONG, REFUSED),
                        s(Double.NEGATIVE_INFINITY, 5, 5, 5)));
    }

    /** Zeros with a sign, and differences that lose their digits when they are multiplied. */
    private static List<Hazard<SegmentsInWindow>> vanishing() {
        return List.of(
                hazard(
                        "signed-zeros",
                        new ClipWindow(0, 0, 3, 6),
                        recorded(EXACT, EXACT, EXACT, EXACT),
                        s(0, -0.0, 0, -0.0),
                        s(1, -0.0, 2, -0.0)),
                hazard(
                        "beyond-by-the-smallest-double",
                        new ClipWindow(0, 0, 5, 3),
                        recorded(WRONG, ENDLESS, EXACT, EXACT),
                        s(-3, 5, 5, -TINY)),
                hazard(
                        "as-wide-as-the-smallest-double",
                        new ClipWindow(0, 3, 0, 6),
                        recorded(WRONG, ENDLESS, WRONG, EXACT),
                        s(TINY, 0, 0, 6)),
                hazard(
                        "rise-of-smallest-doubles",
                        new ClipWindow(-7, 2 * TINY, 1.5, 6.375),
                        recorded(WRONG, ENDLESS, WRONG, EXACT),
                        s(-3.75, 0, 6.75, 5 * TINY)));
    }

    private static double[] s(double x0, double y0, double x1, double y1) {
        return new double[] {x0, y0, x1, y1};
    }

    private static Hazard<SegmentsInWindow> hazard(
            String name,
            ClipWindow window,
            Map<String, Verdict.Kind> recorded,
            double[]... segments) {
        return new Hazard<>(name, new SegmentsInWindow(window, List.of(segments)), recorded);
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind textbook,
            Verdict.Kind nestedTextbook,
            Verdict.Kind floatTextbook,
            Verdict.Kind others) {
        var recorded = new TreeMap<String, Verdict.Kind>();
        for (var method : SegmentClipMethods.all()) recorded.put(method.name(), others);
        recorded.put("cohen-sutherland-textbook", textbook);
        recorded.put("cohen-sutherland-nested-textbook", nestedTextbook);
        recorded.put("cohen-sutherland-float-textbook", floatTextbook);
        return recorded;
    }
}
