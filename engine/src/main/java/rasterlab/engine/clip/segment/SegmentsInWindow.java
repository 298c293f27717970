package rasterlab.engine.clip.segment;

import java.util.List;

/**
 * Segments to clip by one window.
 *
 * @param segments x0, y0, x1, y1 of each; any double, even NaN, which methods refuse
 */
public record SegmentsInWindow(ClipWindow window, List<double[]> segments) {
    public SegmentsInWindow {
        segments = List.copyOf(segments);
        for (int i = 0; i < segments.size(); i++)
            if (segments.get(i).length != 4)
                throw new IllegalArgumentException(
                        "segment " + i + " needs x0, y0, x1, y1, got " + segments.get(i).length);
    }
}
