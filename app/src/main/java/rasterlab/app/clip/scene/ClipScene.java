package rasterlab.app.clip.scene;

import java.util.Map;

/** The figures that one mode of the lab clips, with its methods; immutable, with {@code equals}. */
public sealed interface ClipScene permits SegmentScene, PolygonClipScene, VolumeScene {
    ClipMode mode();

    /** Name of the method whose steps are shown. */
    String method();

    /** Name of a second method, "" for none. */
    String comparison();

    ClipScene withMethod(String other);

    ClipScene withComparison(String other);

    /** Where the points that can be moved are in the picture; none may be finite. */
    Map<ClipGrip, ClipPoint> grips();

    /** The scene with one of the {@link #grips} elsewhere in the picture. */
    ClipScene moved(ClipGrip grip, ClipPoint to);

    /** The scene with one corner or segment more, beside what the grip belongs to. */
    ClipScene grown(ClipGrip beside);

    /**
     * The scene without the corner or segment that the grip belongs to; the same where it is
     * needed.
     */
    ClipScene without(ClipGrip grip);
}
