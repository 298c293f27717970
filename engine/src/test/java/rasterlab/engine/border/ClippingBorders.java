package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.segment.SegmentsInWindow;

/** Segments and polygons to clip. */
final class ClippingBorders {
    private ClippingBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(new SegmentClipTopic(), ClippingBorders::segments)
                        .promising(ClippingBorders::inTheWindow));
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
}
