package rasterlab.app.clip.scene;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.clip.volume.SegmentsInVolume;

/**
 * Segments clipped by the normalised view volume.
 *
 * @param zmin distance of the nearest plane, above 0 and below 1
 * @param screen what the normalisation before was made for
 * @param space in which all is shown
 * @param view from where
 */
public record VolumeScene(
        double zmin,
        List<SpaceSegment> segments,
        String method,
        String comparison,
        Screen screen,
        VolumeSpace space,
        VolumeViewpoint view)
        implements ClipScene {
    /** Segments the lab can show at once. */
    static final int MOST = 8;

    public VolumeScene {
        if (!(zmin > 0 && zmin < 1))
            throw new IllegalArgumentException("zmin must be above 0 and below 1, got " + zmin);
        segments = List.copyOf(segments);
    }

    /** One segment through the near and the far plane, one from behind the eye through a side. */
    public static VolumeScene first() {
        return new VolumeScene(
                0.25,
                List.of(
                        SpaceSegment.of(new double[] {-0.5, -0.35, 0.3, 0.75, 0.6, 1.25}),
                        SpaceSegment.of(new double[] {0.5, 0.45, -0.15, -0.3, -0.35, 0.85})),
                "cohen-sutherland-6",
                "",
                Screen.FIRST,
                VolumeSpace.NORMALIZED,
                VolumeViewpoint.FIRST);
    }

    public VolumeScene showing(SegmentsInVolume input) {
        return new VolumeScene(
                input.zmin(),
                input.segments().stream().map(SpaceSegment::of).toList(),
                method,
                comparison,
                screen,
                space,
                view);
    }

    @Override
    public ClipMode mode() {
        return ClipMode.VOLUME;
    }

    @Override
    public VolumeScene withMethod(String other) {
        return new VolumeScene(zmin, segments, other, comparison, screen, space, view);
    }

    @Override
    public VolumeScene withComparison(String other) {
        return new VolumeScene(zmin, segments, method, other, screen, space, view);
    }

    public VolumeScene withZmin(double other) {
        return new VolumeScene(other, segments, method, comparison, screen, space, view);
    }

    public VolumeScene withScreen(Screen other) {
        return new VolumeScene(zmin, segments, method, comparison, other, space, view);
    }

    public VolumeScene withSpace(VolumeSpace other) {
        return new VolumeScene(zmin, segments, method, comparison, screen, other, view);
    }

    public VolumeScene withView(VolumeViewpoint other) {
        return new VolumeScene(zmin, segments, method, comparison, screen, space, other);
    }

    VolumeScene with(List<SpaceSegment> others) {
        return new VolumeScene(zmin, others, method, comparison, screen, space, view);
    }

    public VolumeScene withEnd(ClipGrip grip, SpacePoint to) {
        SpaceSegment moved = segments.get(grip.index()).moved(grip.end(), to);
        return with(Lists.replaced(segments, grip.index(), moved));
    }

    public SpacePoint end(ClipGrip grip) {
        return segments.get(grip.index()).end(grip.end());
    }

    /** The ends; none in the box after the division, where straight moves are bent. */
    @Override
    public Map<ClipGrip, ClipPoint> grips() {
        var grips = new LinkedHashMap<ClipGrip, ClipPoint>();
        if (space == VolumeSpace.CANONICAL) return grips;
        var picture = new VolumePicture(this);
        for (int i = 0; i < segments.size(); i++)
            for (int end = 0; end < 2; end++)
                grips.put(ClipGrip.end(i, end), picture.of(segments.get(i).end(end)));
        return grips;
    }

    @Override
    public VolumeScene moved(ClipGrip grip, ClipPoint to) {
        return withEnd(grip, new VolumePicture(this).lifted(end(grip), to));
    }

    @Override
    public VolumeScene grown(ClipGrip beside) {
        if (segments.size() >= MOST) return this;
        SpaceSegment source = segments.get(beside.index());
        var copy = new SpaceSegment(higher(source.a()), higher(source.b()));
        return with(Lists.inserted(segments, segments.size(), copy));
    }

    private static SpacePoint higher(SpacePoint p) {
        return new SpacePoint(p.x(), p.y() + 0.125, p.z());
    }

    @Override
    public VolumeScene without(ClipGrip grip) {
        return segments.size() == 1 ? this : with(Lists.removed(segments, grip.index()));
    }
}
