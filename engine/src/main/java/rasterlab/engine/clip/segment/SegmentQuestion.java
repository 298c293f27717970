package rasterlab.engine.clip.segment;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.clip.ClippedEnds;
import rasterlab.engine.clip.exact.ExactClip;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;

/**
 * Whether anything is left of a segment from a point near y = x, whose other end lies on that line,
 * by a window that has a corner on it.
 */
final class SegmentQuestion implements PointQuestion<SegmentsInWindow, ClippedEnds> {
    private static final double CORNER = 12;
    private static final double END = 24;
    private static final double WHOLE = 100;

    @Override
    public int size() {
        return 64;
    }

    @Override
    public double left(Spacing spacing) {
        return spacing == Spacing.WHOLE ? WHOLE : HALF;
    }

    @Override
    public double low(Spacing spacing) {
        return left(spacing);
    }

    /** The listing in whole numbers rounds all fractions away. */
    @Override
    public Spacing spacing(String method) {
        return method.equals("cohen-sutherland-textbook") ? Spacing.WHOLE : Spacing.DOUBLE;
    }

    @Override
    public SegmentsInWindow input(Spacing spacing, double x, double y) {
        double unit = spacing == Spacing.WHOLE ? WHOLE : 1;
        double corner = unit * CORNER;
        double end = unit * END;
        return new SegmentsInWindow(
                new ClipWindow(corner, -end, end, corner), List.of(new double[] {x, y, end, end}));
    }

    @Override
    public boolean yes(ClippedEnds output) {
        return output.kept() > 0;
    }

    @Override
    public Optional<Boolean> right(SegmentsInWindow input) {
        ClipWindow window = input.window();
        double[] sides = {window.xmin(), window.ymin(), window.xmax(), window.ymax()};
        return Optional.of(
                input.segments().stream().anyMatch(ends -> ExactClip.meets(sides, ends)));
    }
}
