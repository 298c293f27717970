package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import java.util.List;
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
                        PolygonClipMutants::withTouched));
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
}
