package rasterlab.engine.clip.volume;

import java.util.List;

/**
 * Segments to clip by the normalised view volume.
 *
 * @param zmin distance of the nearest plane, above 0 and below 1
 * @param segments x0, y0, z0, x1, y1, z1 of each; any double, even NaN, which methods refuse
 */
public record SegmentsInVolume(double zmin, List<double[]> segments) {
    public SegmentsInVolume {
        UnroundedVolume.requireInside(zmin);
        segments = List.copyOf(segments);
        for (int i = 0; i < segments.size(); i++)
            if (segments.get(i).length != 6)
                throw new IllegalArgumentException(
                        "segment "
                                + i
                                + " needs x0, y0, z0, x1, y1, z1, got "
                                + segments.get(i).length
                                + " numbers");
    }
}
