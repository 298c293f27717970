package rasterlab.app.clip;

import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.clip.outcome.ClipResults;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.PolygonClipping;
import rasterlab.app.clip.outcome.WrongParts;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.VolumeScene;

/**
 * The picture of one method on a stage.
 *
 * @param method whose colour is what is left
 * @param other a second method whose colour is what it alone left, "" for none
 * @param labels where no region's code may stand
 */
record ClipPicture(
        List<ClipMark> drawn, String method, String other, boolean ruled, List<Rectangle> labels)
        implements PlanePicture {
    ClipPicture {
        drawn = List.copyOf(drawn);
        labels = List.copyOf(labels);
    }

    /** The chosen method beside the exact answer, or beside the second method. */
    static ClipPicture first(ClipLabState state, Locale locale) {
        ClipResults results = state.results();
        boolean difference = state.choice().difference() && results.other().isPresent();
        return difference
                ? difference(results, results.other().orElseThrow(), state.step(), locale)
                : of(results.scene(), results.clipping(), state.step(), locale);
    }

    /**
     * A method beside the exact answer.
     *
     * @param step as {@link ClipLabState#step}
     */
    static ClipPicture of(ClipScene scene, Clipping clipping, int step, Locale locale) {
        var wrong = new ArrayList<ClipMark>();
        add(wrong, scene, clipping.wrong().missing(), ClipMark.MarkMeaning.MISSING);
        add(wrong, scene, clipping.wrong().extra(), ClipMark.MarkMeaning.EXTRA);
        return of(scene, clipping, "", step, wrong, locale);
    }

    private static ClipPicture difference(
            ClipResults results, Clipping other, int step, Locale locale) {
        WrongParts between =
                WrongParts.between(
                        edges(results.scene(), other),
                        edges(results.scene(), results.clipping()),
                        results.unit());
        var wrong = new ArrayList<ClipMark>();
        add(wrong, results.scene(), between.missing(), ClipMark.MarkMeaning.ONLY_SECOND);
        add(wrong, results.scene(), between.extra(), ClipMark.MarkMeaning.ONLY_FIRST);
        return of(results.scene(), results.clipping(), other.method(), step, wrong, locale);
    }

    private static List<double[]> edges(ClipScene scene, Clipping clipping) {
        List<double[]> parts =
                clipping.parts().stream().map(Clipping.ClipPart::coordinates).toList();
        return scene instanceof PolygonClipScene ? PolygonClipping.edges(parts) : parts;
    }

    private static void add(
            List<ClipMark> wrong, ClipScene scene, List<double[]> edges, ClipMark.MarkMeaning ink) {
        List<double[]> shown =
                scene instanceof VolumeScene volume
                        ? VolumeDrawing.inPicture(volume, edges)
                        : edges;
        for (double[] edge : shown) wrong.add(ClipMark.MarkedLine.of(edge, ink));
    }

    private static ClipPicture of(
            ClipScene scene,
            Clipping clipping,
            String other,
            int step,
            List<ClipMark> wrong,
            Locale locale) {
        List<ClipMark> drawn;
        if (scene instanceof SegmentScene segments)
            drawn = SegmentDrawing.of(segments, clipping, step, wrong, locale);
        else if (scene instanceof PolygonClipScene polygon)
            drawn = PolygonDrawing.of(polygon, clipping, step, wrong);
        else drawn = VolumeDrawing.of((VolumeScene) scene, clipping, step, wrong, locale);
        return new ClipPicture(
                drawn, clipping.method(), other, scene.mode() != ClipMode.VOLUME, List.of());
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        new ClipPainter(g, map, colors, method, other, labels).paint(drawn, cancelled);
    }

    @Override
    public List<Line2D> lines(PlaneMap map, Rectangle view) {
        var inView = new InView(map, view);
        return Stream.of(ClipMark.MarkMeaning.GIVEN, ClipMark.MarkMeaning.WINDOW)
                .flatMap(ink -> ClipPainter.segments(drawn, inView, ink).stream())
                .toList();
    }

    @Override
    public ClipPicture leaving(List<Rectangle> places) {
        return new ClipPicture(drawn, method, other, ruled, places);
    }
}
