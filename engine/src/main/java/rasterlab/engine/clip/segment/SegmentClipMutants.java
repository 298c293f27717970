package rasterlab.engine.clip.segment;

import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.SegmentClipper;
import rasterlab.contract.SegmentSink;
import rasterlab.engine.study.Mutant;

/** Segments clipped with one mistake. */
final class SegmentClipMutants {
    private static final double MOST = Double.MAX_VALUE;
    private static final SegmentClipper RIGHT = new LiangBarsky();

    private SegmentClipMutants() {}

    static List<Mutant<SegmentClipper>> all() {
        return Stream.of(sides(), ends(), cuts()).flatMap(List::stream).toList();
    }

    private static List<Mutant<SegmentClipper>> sides() {
        return List.of(
                new Mutant<>(
                        "left-does-not-cut",
                        "only-left",
                        (l, b, r, t, x0, y0, x1, y1, out) ->
                                RIGHT.clip(-MOST, b, r, t, x0, y0, x1, y1, out)),
                new Mutant<>(
                        "bottom-does-not-cut",
                        "only-below",
                        (l, b, r, t, x0, y0, x1, y1, out) ->
                                RIGHT.clip(l, -MOST, r, t, x0, y0, x1, y1, out)),
                new Mutant<>(
                        "top-does-not-cut",
                        "inside-and-above",
                        (l, b, r, t, x0, y0, x1, y1, out) ->
                                RIGHT.clip(l, b, r, MOST, x0, y0, x1, y1, out)),
                new Mutant<>(
                        "ymax-for-xmax",
                        "window-not-square",
                        (l, b, r, t, x0, y0, x1, y1, out) ->
                                RIGHT.clip(l, b, Math.max(l, t), t, x0, y0, x1, y1, out)));
    }

    private static List<Mutant<SegmentClipper>> ends() {
        return List.of(
                new Mutant<>(
                        "ends-moved-to-the-sides",
                        "through-the-window",
                        (l, b, r, t, x0, y0, x1, y1, out) ->
                                out.segment(
                                        between(l, r, x0),
                                        between(b, t, y0),
                                        between(l, r, x1),
                                        between(b, t, y1))),
                new Mutant<>(
                        "always-left-to-right",
                        "swapped-ends",
                        (l, b, r, t, x0, y0, x1, y1, out) -> {
                            if (x0 <= x1) RIGHT.clip(l, b, r, t, x0, y0, x1, y1, out);
                            else RIGHT.clip(l, b, r, t, x1, y1, x0, y0, out);
                        }),
                new Mutant<>(
                        "point-left-dropped",
                        "touches-a-corner",
                        sending(
                                (given, out) ->
                                        (x0, y0, x1, y1) -> {
                                            if (x0 != x1 || y0 != y1 || given.isPoint())
                                                out.segment(x0, y0, x1, y1);
                                        })),
                new Mutant<>(
                        "point-segment-dropped",
                        "single-points",
                        sending(
                                (given, out) ->
                                        (x0, y0, x1, y1) -> {
                                            if (!given.isPoint()) out.segment(x0, y0, x1, y1);
                                        })),
                new Mutant<>(
                        "flat-window-holds-nothing",
                        "window-without-area",
                        (l, b, r, t, x0, y0, x1, y1, out) -> {
                            if (l < r && b < t) RIGHT.clip(l, b, r, t, x0, y0, x1, y1, out);
                        }),
                new Mutant<>(
                        "inner-end-recomputed",
                        "ends-stay",
                        sending(
                                (given, out) ->
                                        (x0, y0, x1, y1) ->
                                                out.segment(
                                                        x0, y0, x0 + (x1 - x0), y0 + (y1 - y0)))));
    }

    private static List<Mutant<SegmentClipper>> cuts() {
        return List.of(
                new Mutant<>(
                        "both-ends-out-dropped",
                        "through-the-window",
                        (l, b, r, t, x0, y0, x1, y1, out) -> {
                            if (isIn(l, b, r, t, x0, y0) || isIn(l, b, r, t, x1, y1))
                                RIGHT.clip(l, b, r, t, x0, y0, x1, y1, out);
                        }),
                new Mutant<>(
                        "always-reversed",
                        "inside-and-above",
                        (l, b, r, t, x0, y0, x1, y1, out) ->
                                RIGHT.clip(l, b, r, t, x1, y1, x0, y0, out)),
                new Mutant<>(
                        "ends-in-whole-numbers",
                        "fractions",
                        sending(
                                (given, out) ->
                                        (x0, y0, x1, y1) ->
                                                out.segment(
                                                        Math.rint(x0),
                                                        Math.rint(y0),
                                                        Math.rint(x1),
                                                        Math.rint(y1)))),
                new Mutant<>(
                        "only-the-start-cut",
                        "inside-and-above",
                        sending(
                                (given, out) ->
                                        (x0, y0, x1, y1) ->
                                                out.segment(x0, y0, given.x1(), given.y1()))));
    }

    private static double between(double least, double most, double value) {
        return Math.max(least, Math.min(most, value));
    }

    private record Given(double x0, double y0, double x1, double y1) {
        boolean isPoint() {
            return x0 == x1 && y0 == y1;
        }
    }

    private interface Sending {
        SegmentSink to(Given given, SegmentSink out);
    }

    private static SegmentClipper sending(Sending sending) {
        return (l, b, r, t, x0, y0, x1, y1, out) ->
                RIGHT.clip(l, b, r, t, x0, y0, x1, y1, sending.to(new Given(x0, y0, x1, y1), out));
    }

    private static boolean isIn(double l, double b, double r, double t, double x, double y) {
        return l <= x && x <= r && b <= y && y <= t;
    }
}
