package rasterlab.engine.clip.volume;

import java.util.List;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;

/**
 * Whether anything is left of a segment that passes the volume's edge x = z = 1, on which it lies
 * but for its last digits: the map's y is z, and the segment ends on x + z = 2.
 */
final class VolumeQuestion implements PointQuestion<SegmentsInVolume, ClippedEnds> {
    private static final double NEAREST = 0.1;
    private static final double BEYOND = 1.5;
    private static final double END_X = 24;
    private static final double END_Z = -22;

    @Override
    public int size() {
        return 64;
    }

    @Override
    public double left(Spacing spacing) {
        return HALF;
    }

    @Override
    public double low(Spacing spacing) {
        return BEYOND;
    }

    @Override
    public SegmentsInVolume input(Spacing spacing, double x, double y) {
        return new SegmentsInVolume(NEAREST, List.of(new double[] {x, 0, y, END_X, 0, END_Z}));
    }

    @Override
    public boolean yes(ClippedEnds output) {
        return output.kept() > 0;
    }
}
