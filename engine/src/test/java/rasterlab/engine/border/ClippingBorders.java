package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.exact.ProperInput;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SegmentsInWindow;
import rasterlab.engine.clip.volume.SegmentsInVolume;
import rasterlab.engine.clip.volume.VolumeClipTopic;

/** Segments and polygons to clip. */
final class ClippingBorders {
    private ClippingBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(new SegmentClipTopic(), ClippingBorders::segments)
                        .promising(ClippingBorders::inTheWindow),
                Border.of(
                                new PolygonClipTopic(),
                                ClippingBorders::polygon,
                                (method, input, message) ->
                                        !ProperInput.is(input.window(), input.subject()))
                        .slow(0.2),
                Border.of(new VolumeClipTopic(), ClippingBorders::volume)
                        .promising(ClippingBorders::inTheVolume)
                        .slow(0.5));
    }

    private static SegmentsInWindow segments(Draws draws) {
        ClipWindow window = window(draws);
        var segments = new ArrayList<double[]>();
        for (int i = draws.pick(2); i >= 0; i--) segments.add(draws.numbers(4));
        return new SegmentsInWindow(window, segments);
    }

    /** Two corners, whichever way round. */
    static ClipWindow window(Draws draws) {
        double[] corners = draws.numbers(4);
        return new ClipWindow(
                Math.min(corners[0], corners[2]),
                Math.min(corners[1], corners[3]),
                Math.max(corners[0], corners[2]),
                Math.max(corners[1], corners[3]));
    }

    private static boolean inTheWindow(SegmentsInWindow input, ClippedEnds ends) {
        ClipWindow window = input.window();
        return ends.parts().stream()
                .flatMap(Optional::stream)
                .allMatch(p -> window.code(p[0], p[1]) == 0 && window.code(p[2], p[3]) == 0);
    }

    /** A rectangle or a triangle, and up to five corners. */
    private static PolygonInWindow polygon(Draws draws) {
        ClipWindow box = window(draws);
        double[] window =
                draws.pick(3) == 2
                        ? PlaneBorders.coordinates(draws, 3)
                        : PolygonInWindow.rectangle(box.xmin(), box.ymin(), box.xmax(), box.ymax());
        return new PolygonInWindow(window, PlaneBorders.coordinates(draws, 3 + draws.pick(3)));
    }

    private static SegmentsInVolume volume(Draws draws) {
        double zmin = draws.number(Double.MIN_VALUE, Math.nextDown(1.0));
        var segments = new ArrayList<double[]>();
        for (int i = draws.pick(2); i >= 0; i--) segments.add(draws.numbers(6));
        return new SegmentsInVolume(zmin, segments);
    }

    private static boolean inTheVolume(SegmentsInVolume input, ClippedEnds ends) {
        return ends.parts().stream()
                .flatMap(Optional::stream)
                .allMatch(
                        p ->
                                inTheVolume(input.zmin(), p[0], p[1], p[2])
                                        && inTheVolume(input.zmin(), p[3], p[4], p[5]));
    }

    private static boolean inTheVolume(double zmin, double x, double y, double z) {
        return Math.abs(x) <= z && Math.abs(y) <= z && zmin <= z && z <= 1;
    }
}
