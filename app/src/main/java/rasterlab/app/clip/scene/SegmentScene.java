package rasterlab.app.clip.scene;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.clip.segment.ClipWindow;
import rasterlab.engine.clip.segment.SegmentsInWindow;

/** Segments clipped by a window. */
public record SegmentScene(
        ShownWindow window, List<PlaneSegment> segments, String method, String comparison)
        implements ClipScene {
    /** Segments the lab can show at once. */
    static final int MOST = 12;

    public SegmentScene {
        segments = List.copyOf(segments);
    }

    /** A window met in every way: cut twice, cut once, passed at a corner, not cut. */
    public static SegmentScene first() {
        return new SegmentScene(
                ShownWindow.of(new ClipWindow(0, 0, 10, 6)),
                List.of(
                        PlaneSegment.of(new double[] {-3, -1.5, 12, 8}),
                        PlaneSegment.of(new double[] {3, 1.7, 13, 3.2}),
                        PlaneSegment.of(new double[] {-4, 3.5, 3, 8.5}),
                        PlaneSegment.of(new double[] {6, 0.8, 8.6, 1.5})),
                "cohen-sutherland",
                "");
    }

    public SegmentScene showing(SegmentsInWindow input) {
        return new SegmentScene(
                ShownWindow.of(input.window()),
                input.segments().stream().map(PlaneSegment::of).toList(),
                method,
                comparison);
    }

    /**
     * The scene with the window as a rectangle or a polygon; a polygon is what cyrus-beck is for.
     */
    public SegmentScene shaped(boolean upright) {
        return new SegmentScene(
                window.shaped(upright),
                segments,
                upright ? method : "cyrus-beck",
                upright ? comparison : "");
    }

    @Override
    public ClipMode mode() {
        return ClipMode.SEGMENTS;
    }

    @Override
    public SegmentScene withMethod(String other) {
        return new SegmentScene(window, segments, other, comparison);
    }

    @Override
    public SegmentScene withComparison(String other) {
        return new SegmentScene(window, segments, method, other);
    }

    private SegmentScene with(ShownWindow other) {
        return new SegmentScene(other, segments, method, comparison);
    }

    private SegmentScene with(List<PlaneSegment> others) {
        return new SegmentScene(window, others, method, comparison);
    }

    @Override
    public Map<ClipGrip, ClipPoint> grips() {
        var grips = new LinkedHashMap<ClipGrip, ClipPoint>();
        for (int i = 0; i < segments.size(); i++)
            for (int end = 0; end < 2; end++)
                grips.put(ClipGrip.end(i, end), segments.get(i).end(end));
        for (int i = 0; i < window.corners().size(); i++)
            grips.put(ClipGrip.window(i), window.corners().get(i));
        return grips;
    }

    @Override
    public SegmentScene moved(ClipGrip grip, ClipPoint to) {
        if (grip.kind() == ClipGrip.ClipGripKind.WINDOW)
            return with(window.moved(grip.index(), to));
        PlaneSegment moved = segments.get(grip.index()).moved(grip.end(), to);
        return with(Lists.replaced(segments, grip.index(), moved));
    }

    @Override
    public SegmentScene grown(ClipGrip beside) {
        if (beside.kind() == ClipGrip.ClipGripKind.WINDOW)
            return with(window.grown(beside.index()));
        if (segments.size() >= MOST) return this;
        ClipWindow sides = window.rectangle();
        double dx = (sides.xmax() - sides.xmin()) / 8;
        PlaneSegment source = segments.get(beside.index());
        var copy =
                new PlaneSegment(
                        new ClipPoint(source.a().x() + dx, source.a().y()),
                        new ClipPoint(source.b().x() + dx, source.b().y()));
        return with(Lists.inserted(segments, segments.size(), copy));
    }

    @Override
    public SegmentScene without(ClipGrip grip) {
        if (grip.kind() == ClipGrip.ClipGripKind.WINDOW) return with(window.without(grip.index()));
        return segments.size() == 1 ? this : with(Lists.removed(segments, grip.index()));
    }
}
