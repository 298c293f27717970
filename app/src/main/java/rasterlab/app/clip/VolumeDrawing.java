package rasterlab.app.clip;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import rasterlab.app.clip.outcome.Border;
import rasterlab.app.clip.outcome.ClipStep;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.Codes;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.SpacePoint;
import rasterlab.app.clip.scene.SpaceSegment;
import rasterlab.app.clip.scene.VolumePicture;
import rasterlab.app.clip.scene.VolumeScene;
import rasterlab.app.clip.scene.VolumeSpace;

/** The wire picture of segments in the view volume. */
final class VolumeDrawing {
    /** Corners of the volume: near ones first, each time round from x, y below 0. */
    private static final int[][] FACES = {
        {3, 2, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {0, 3, 7, 4}, {4, 5, 6, 7}, {0, 1, 2, 3}
    };

    /** Steps of a line that the division bends or sends to infinity. */
    private static final double JUST_IN_FRONT = 1e-3;

    private final VolumeScene scene;
    private final VolumePicture picture;
    private final Locale locale;
    private final List<ClipMark> drawn = new ArrayList<>();

    private VolumeDrawing(VolumeScene scene, Locale locale) {
        this.scene = scene;
        this.locale = locale;
        picture = new VolumePicture(scene);
    }

    /**
     * @param step as {@link ClipLabState#step}
     * @param wrong what is wrong, marked when the result is shown
     */
    static List<ClipMark> of(
            VolumeScene scene, Clipping clipping, int step, List<ClipMark> wrong, Locale locale) {
        var drawing = new VolumeDrawing(scene, locale);
        ClipStep current =
                step > 0 && step <= clipping.steps().size() ? clipping.steps().get(step - 1) : null;
        drawing.volume(current == null ? -1 : current.border());
        for (SpaceSegment segment : scene.segments())
            drawing.line(segment.ends(), ClipMark.MarkMeaning.GIVEN);
        boolean finished = step > clipping.steps().size();
        if (finished) drawing.parts(clipping, Integer.MAX_VALUE);
        if (current != null) drawing.step(clipping, current);
        if (finished) drawing.drawn.addAll(wrong);
        return drawing.drawn;
    }

    /** The wrong edges, in the picture. */
    static List<double[]> inPicture(VolumeScene scene, List<double[]> edges) {
        var picture = new VolumePicture(scene);
        return edges.stream()
                .filter(ends -> picture.inFront(first(ends)) && picture.inFront(second(ends)))
                .map(ends -> pair(picture.of(first(ends)), picture.of(second(ends))))
                .toList();
    }

    private static double[] pair(ClipPoint a, ClipPoint b) {
        return new double[] {a.x(), a.y(), b.x(), b.y()};
    }

    private static SpacePoint first(double[] ends) {
        return new SpacePoint(ends[0], ends[1], ends[2]);
    }

    private static SpacePoint second(double[] ends) {
        return new SpacePoint(ends[3], ends[4], ends[5]);
    }

    private SpacePoint corner(int index) {
        double z = index < 4 ? scene.zmin() : 1;
        int round = index % 4;
        return new SpacePoint(round == 1 || round == 2 ? z : -z, round >= 2 ? z : -z, z);
    }

    /** Draws the six faces; an edge between two that are turned away is behind the others. */
    private void volume(int tested) {
        if (scene.space() != VolumeSpace.CANONICAL) eye();
        add(new ClipMark.MarkedArea(face(4), ClipMark.MarkMeaning.WINDOW));
        add(new ClipMark.MarkedArea(face(5), ClipMark.MarkMeaning.WINDOW));
        var seen = new boolean[6];
        for (int face = 0; face < 6; face++) seen[face] = scene.view().faces(outward(face));
        if (tested >= 0) add(new ClipMark.MarkedArea(face(tested), ClipMark.MarkMeaning.TESTED));
        for (int one = 0; one < 6; one++)
            for (int other = one + 1; other < 6; other++)
                edge(one, other, seen[one] || seen[other]);
        if (tested >= 0)
            add(new ClipMark.MarkedLine(face(tested), true, ClipMark.MarkMeaning.TESTED));
    }

    private void edge(int one, int other, boolean seen) {
        int[] shared =
                Arrays.stream(FACES[one])
                        .filter(corner -> Arrays.stream(FACES[other]).anyMatch(c -> c == corner))
                        .toArray();
        if (shared.length != 2) return;
        List<ClipPoint> ends =
                List.of(picture.of(corner(shared[0])), picture.of(corner(shared[1])));
        add(
                new ClipMark.MarkedLine(
                        ends,
                        false,
                        seen ? ClipMark.MarkMeaning.WINDOW : ClipMark.MarkMeaning.HIDDEN));
    }

    private List<ClipPoint> face(int face) {
        return Arrays.stream(FACES[face]).mapToObj(this::corner).map(picture::of).toList();
    }

    /** Normal of a face in the space that is shown, away from the volume's middle. */
    private SpacePoint outward(int face) {
        SpacePoint a = picture.shown(corner(FACES[face][0]));
        SpacePoint b = picture.shown(corner(FACES[face][1]));
        SpacePoint c = picture.shown(corner(FACES[face][3]));
        var normal =
                new SpacePoint(
                        (b.y() - a.y()) * (c.z() - a.z()) - (b.z() - a.z()) * (c.y() - a.y()),
                        (b.z() - a.z()) * (c.x() - a.x()) - (b.x() - a.x()) * (c.z() - a.z()),
                        (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
        SpacePoint middle = picture.shown(new SpacePoint(0, 0, (1 + scene.zmin()) / 2));
        double towards =
                normal.x() * (middle.x() - a.x())
                        + normal.y() * (middle.y() - a.y())
                        + normal.z() * (middle.z() - a.z());
        return towards > 0 ? new SpacePoint(-normal.x(), -normal.y(), -normal.z()) : normal;
    }

    /** Draws the eye, and the rays from it to the nearest corners. */
    private void eye() {
        ClipPoint at = picture.of(new SpacePoint(0, 0, 0));
        for (int i = 0; i < 4; i++)
            add(
                    new ClipMark.MarkedLine(
                            List.of(at, picture.of(corner(i))), false, ClipMark.MarkMeaning.HELP));
        ClipPoint ahead = picture.of(new SpacePoint(0, 0, 1));
        add(
                new ClipMark.MarkedSign(
                        at, ahead.x() - at.x(), ahead.y() - at.y(), ClipMark.SignShape.EYE, ""));
    }

    private void add(ClipMark one) {
        drawn.add(one);
    }

    /**
     * Draws a segment of the normalised space; after the division only what lies before the eye.
     */
    private void line(double[] ends, ClipMark.MarkMeaning ink) {
        if (ends.length == 0) return;
        double[] shown = scene.space() == VolumeSpace.CANONICAL ? inFront(ends) : ends;
        if (shown.length > 0)
            add(
                    new ClipMark.MarkedLine(
                            List.of(picture.of(first(shown)), picture.of(second(shown))),
                            false,
                            ink));
    }

    private static double[] inFront(double[] ends) {
        var front = new Border(new double[] {0, 0, 1}, -JUST_IN_FRONT);
        boolean from = front.distance(ends, 0) >= 0;
        boolean to = front.distance(ends, 1) >= 0;
        if (from && to) return ends;
        if (!from && !to) return new double[0];
        double[] met = front.meeting(ends);
        double[] cut = ends.clone();
        System.arraycopy(met, 0, cut, from ? 3 : 0, 3);
        return cut;
    }

    private void parts(Clipping clipping, int before) {
        for (Clipping.ClipPart part : clipping.parts())
            if (part.item() < before) line(part.coordinates(), ClipMark.MarkMeaning.LEFT);
    }

    private void step(Clipping clipping, ClipStep step) {
        parts(clipping, step.item());
        line(step.left(), ClipMark.MarkMeaning.STEP);
        if (step.places().length == 0) return;
        double[] ends = scene.segments().get(step.item()).ends();
        ClipPoint from = picture.of(first(ends));
        ClipPoint to = picture.of(second(ends));
        var at = new SpacePoint(step.places()[0], step.places()[1], step.places()[2]);
        if (picture.inFront(at))
            add(
                    new ClipMark.MarkedSign(
                            picture.of(at),
                            to.x() - from.x(),
                            to.y() - from.y(),
                            SegmentDrawing.shape(step.passing()),
                            Codes.decision(clipping.decidesByCode(), step, locale)));
    }
}
