package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonSink;
import rasterlab.engine.study.Mutant;

/** Polygons clipped with one mistake. */
final class PolygonClipMutants {
    private static final PolygonClipper RIGHT = new WeilerAtherton();

    private PolygonClipMutants() {}

    static List<Mutant<PolygonClipper>> all() {
        return List.of(
                new Mutant<>("bridges", "two-pieces", new SutherlandHodgman()),
                new Mutant<>("winds-as-polygon", "clockwise", PolygonClipMutants::asTheSubject),
                new Mutant<>(
                        "around-is-lost",
                        "around",
                        (window, subject, out) ->
                                RIGHT.clip(
                                        window,
                                        subject,
                                        piece -> {
                                            if (!Arrays.equals(piece, window)) out.polygon(piece);
                                        })),
                new Mutant<>(
                        "inside-is-lost",
                        "inside",
                        (window, subject, out) ->
                                RIGHT.clip(
                                        window,
                                        subject,
                                        piece -> {
                                            if (!isInside(window, subject)) out.polygon(piece);
                                        })),
                new Mutant<>(
                        "window-as-box",
                        "convex-window",
                        (window, subject, out) -> RIGHT.clip(box(window), subject, out)),
                new Mutant<>(
                        "touch-is-a-piece",
                        "touches-from-outside",
                        PolygonClipMutants::withTouched),
                new Mutant<>("leaving-points-left-out", "convex", sides(1, 0, 0)),
                new Mutant<>("entering-points-left-out", "convex", sides(0, 1, 0)),
                new Mutant<>("last-side-forgotten", "convex-window", sides(0, 0, 1)));
    }

    private static void asTheSubject(double[] window, double[] subject, PolygonSink out) {
        boolean clockwise = PolygonArea.of(subject) < 0;
        RIGHT.clip(window, subject, piece -> out.polygon(clockwise ? backwards(piece) : piece));
    }

    private static double[] backwards(double[] piece) {
        var back = new double[piece.length];
        for (int i = 0; i < piece.length; i += 2) {
            back[i] = piece[piece.length - 2 - i];
            back[i + 1] = piece[piece.length - 1 - i];
        }
        return back;
    }

    private static double[] box(double[] window) {
        double[] b = {window[0], window[1], window[0], window[1]};
        for (int i = 2; i < window.length; i += 2)
            for (int c = 0; c < 2; c++) {
                b[c] = Math.min(b[c], window[i + c]);
                b[2 + c] = Math.max(b[2 + c], window[i + c]);
            }
        return PolygonInWindow.rectangle(b[0], b[1], b[2], b[3]);
    }

    private static boolean isInside(double[] window, double[] subject) {
        double[] outer = box(window);
        double[] inner = box(subject);
        return inner[0] > outer[0]
                && inner[1] > outer[1]
                && inner[4] < outer[4]
                && inner[5] < outer[5];
    }

    private static void withTouched(double[] window, double[] subject, PolygonSink out) {
        RIGHT.clip(window, subject, out);
        double[] b = box(window);
        for (int i = 0; i < subject.length; i += 2) {
            double x = subject[i];
            double y = subject[i + 1];
            if (x == b[4] && y > b[1] && y < b[5]) out.polygon(new double[] {x, y, x, y, x, y});
        }
    }

    /**
     * Clips by one side after the other.
     *
     * @param leaving 1 where the points at which the outline leaves are left out
     * @param entering 1 where those at which it comes in are
     * @param sides how many sides at the end of the window are forgotten
     */
    private static PolygonClipper sides(int leaving, int entering, int sides) {
        return (window, subject, out) -> {
            double[] w = PolygonArea.of(window) < 0 ? backwards(window) : window;
            double[] left = PolygonArea.of(subject) < 0 ? backwards(subject) : subject;
            for (int i = 0; i < w.length - 2 * sides; i += 2)
                left = cut(left, w, i, leaving == 1, entering == 1);
            if (left.length > 4 && PolygonArea.of(left) > 1e-12 * PolygonArea.of(w))
                out.polygon(left);
        };
    }

    private static double[] cut(
            double[] ring, double[] window, int side, boolean leaving, boolean entering) {
        var kept = DoubleStream.builder();
        for (int i = 0; i < ring.length; i += 2) {
            int j = (i + 2) % ring.length;
            double p = inward(window, side, ring[i], ring[i + 1]);
            double q = inward(window, side, ring[j], ring[j + 1]);
            if (p >= 0) kept.add(ring[i]).add(ring[i + 1]);
            if (p > 0 && q < 0 && leaving || p < 0 && q > 0 && entering || p * q >= 0) continue;
            double t = p / (p - q);
            kept.add(ring[i] + t * (ring[j] - ring[i]));
            kept.add(ring[i + 1] + t * (ring[j + 1] - ring[i + 1]));
        }
        return kept.build().toArray();
    }

    private static double inward(double[] w, int side, double x, double y) {
        int next = (side + 2) % w.length;
        return (w[next] - w[side]) * (y - w[side + 1])
                - (w[next + 1] - w[side + 1]) * (x - w[side]);
    }
}
