package rasterlab.engine.clip.volume;

import static rasterlab.engine.study.Verdict.Kind.DEGRADED;
import static rasterlab.engine.study.Verdict.Kind.EXACT;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;
import static rasterlab.engine.study.Verdict.Kind.WRONG;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Verdict;

/** Segments in space on which methods fail, and what each method is known to make of them. */
final class VolumeClipHazards {
    private static final double NEAREST = 0.125;
    private static final double MOST = Double.MAX_VALUE;

    private VolumeClipHazards() {}

    static List<Hazard<SegmentsInVolume>> all() {
        var all = new ArrayList<>(crossing());
        all.addAll(touching());
        all.addAll(extreme());
        return all;
    }

    /** Planes and the eye on the way. */
    private static List<Hazard<SegmentsInVolume>> crossing() {
        return List.of(
                hazard(
                        "through-each-plane",
                        NEAREST,
                        recorded(EXACT, EXACT),
                        s(0, 0, 0.5, 0.1, 2, 0.5),
                        s(0, 0, 0.5, 0.1, -2, 0.5),
                        s(0, 0, 0.5, 2, 0.1, 0.5),
                        s(0, 0, 0.5, -2, 0.1, 0.5),
                        s(0, 0, 0.5, 0.1, 0.1, 3),
                        s(0, 0, 0.5, 0, 0, 0.01)),
                hazard(
                        "from-far-to-near",
                        NEAREST,
                        recorded(EXACT, DEGRADED),
                        s(0.1, 0.2, 0.9, 0.15, 0.1, 0.3),
                        s(0.2, 0.1, 1.75, 0, 0.1, 0.5)),
                hazard(
                        "past-an-edge",
                        NEAREST,
                        recorded(EXACT, EXACT),
                        s(0.9, 0.2, 0.5, 0.2, 0.9, 0.25),
                        s(2, 0, 0.9, 0, 0, 1.5)),
                hazard(
                        "through-the-eye",
                        NEAREST,
                        recorded(EXACT, WRONG),
                        s(0, 0, -1, 0, 0, 1),
                        s(-0.5, -0.5, -0.5, 0.5, 0.5, 0.5)),
                hazard(
                        "behind-the-eye",
                        NEAREST,
                        recorded(EXACT, WRONG),
                        s(0.1, 0.1, -0.5, -0.2, 0.1, -0.9),
                        s(0.1, 0, -0.5, 0.2, 0.1, 0.5),
                        s(3, 0, -1, -0.2, 0, 0.6)),
                hazard(
                        "at-the-eye",
                        NEAREST,
                        recorded(EXACT, WRONG),
                        s(0, 0, 0, 0.3, 0.2, 0.7),
                        s(0, 0, 0, 0, 0, 0)));
    }

    /** Where little is left. */
    private static List<Hazard<SegmentsInVolume>> touching() {
        return List.of(
                hazard(
                        "along-an-edge",
                        NEAREST,
                        recorded(EXACT, WRONG),
                        s(0, 0, 0, 1, 1, 1),
                        s(0.25, -0.25, 0.25, 2, -2, 2)),
                hazard(
                        "touches-an-edge",
                        NEAREST,
                        recorded(EXACT, EXACT),
                        s(0.75, 0.25, 0.5, 0.25, 0.75, 0.5),
                        s(1.5, 0.5, 1, 0.5, 1.5, 1),
                        s(1, 1, 0.5, 1, 1, 2)),
                hazard(
                        "misses-an-edge-by-one-step",
                        NEAREST,
                        recorded(EXACT, EXACT),
                        s(Math.nextUp(0.75), 0.25, 0.5, 0.25, 0.75, 0.5),
                        s(1, Math.nextUp(1.0), 0.5, 1, 1, 1.5)),
                hazard(
                        "single-points",
                        NEAREST,
                        recorded(EXACT, EXACT),
                        s(0, 0, 0.5, 0, 0, 0.5),
                        s(1, 1, 1, 1, 1, 1),
                        s(0.5, 0, 0.4, 0.5, 0, 0.4)));
    }

    /** Numbers at the limits of doubles and beyond. */
    private static List<Hazard<SegmentsInVolume>> extreme() {
        return List.of(
                hazard(
                        "nearest-plane-at-the-eye",
                        1e-12,
                        recorded(EXACT, WRONG),
                        s(0, 0, 0.5, 0, 0, 1.5),
                        s(0, 0, -1, 0, 0, 2),
                        s(0.2, 0.1, 0.999999, 0.2, 0.1, 1.000001)),
                hazard(
                        "thin-volume",
                        Math.nextDown(1.0),
                        recorded(EXACT, WRONG),
                        s(0, 0, 0, 0, 0, 2),
                        s(0, 0, 1, 0.5, 0.5, 1),
                        s(0, 0, 1.5, 0.5, 0.5, 1.25)),
                hazard(
                        "ends-at-1e30",
                        NEAREST,
                        recorded(EXACT, WRONG),
                        s(-1e30, -1e30, -1e30, 1e30, 1e30, 1e30),
                        s(0, 0, -1e30, 0.25, 0.125, 1e30)),
                hazard(
                        "largest-doubles",
                        NEAREST,
                        recorded(EXACT, WRONG),
                        s(-MOST, 0, -MOST, MOST, 0, MOST),
                        s(0, 0, 0.5, MOST, 0, MOST)),
                hazard(
                        "not-a-number",
                        NEAREST,
                        recorded(REFUSED, WRONG),
                        s(Double.NaN, 0, 0.5, 0, 0, 0.5)),
                hazard(
                        "infinite",
                        NEAREST,
                        recorded(REFUSED, WRONG),
                        s(0, 0, 0.5, 0, 0, Double.POSITIVE_INFINITY)));
    }

    private static double[] s(double x0, double y0, double z0, double x1, double y1, double z1) {
        return new double[] {x0, y0, z0, x1, y1, z1};
    }

    private static Hazard<SegmentsInVolume> hazard(
            String name, double zmin, Map<String, Verdict.Kind> recorded, double[]... segments) {
        return new Hazard<>(name, new SegmentsInVolume(zmin, List.of(segments)), recorded);
    }

    private static Map<String, Verdict.Kind> recorded(
            Verdict.Kind others, Verdict.Kind divideFirstTextbook) {
        return Map.of(
                "cohen-sutherland-6",
                others,
                "divide-first-textbook",
                divideFirstTextbook,
                "homogeneous",
                others);
    }
}
