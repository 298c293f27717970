package rasterlab.app.clip;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.clip.outcome.ClipStep;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.Codes;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.PlaneSegment;
import rasterlab.app.clip.scene.SegmentScene;
import rasterlab.app.clip.scene.ShownWindow;
import rasterlab.engine.clip.segment.ClipWindow;

/** The picture of segments in a window. */
final class SegmentDrawing {
    /** Half of the length of what stands for an endless line, in window sizes. */
    private static final double FAR = 1e4;

    private final SegmentScene scene;
    private final Locale locale;
    private final List<ClipMark> drawn = new ArrayList<>();

    private SegmentDrawing(SegmentScene scene, Locale locale) {
        this.scene = scene;
        this.locale = locale;
    }

    /**
     * @param step as {@link ClipLabState#step}
     * @param wrong marked when the result is shown
     */
    static List<ClipMark> of(
            SegmentScene scene, Clipping clipping, int step, List<ClipMark> wrong, Locale locale) {
        var drawing = new SegmentDrawing(scene, locale);
        drawing.window(scene.window());
        if (scene.window().upright()) drawing.regions(scene.window().rectangle());
        for (PlaneSegment segment : scene.segments())
            drawing.add(ClipMark.MarkedLine.of(segment.ends(), ClipMark.MarkMeaning.GIVEN));
        boolean finished = step > clipping.steps().size();
        if (finished) drawing.parts(clipping, Integer.MAX_VALUE);
        else if (step > 0) drawing.step(clipping, clipping.steps().get(step - 1));
        if (finished) drawing.drawn.addAll(wrong);
        return drawing.drawn;
    }

    private void add(ClipMark one) {
        drawn.add(one);
    }

    private void window(ShownWindow window) {
        add(new ClipMark.MarkedArea(window.corners(), ClipMark.MarkMeaning.WINDOW));
        if (window.upright())
            for (int i = 0; i < 4; i++)
                add(endless(window.rectangle(), i, ClipMark.MarkMeaning.HELP));
        add(new ClipMark.MarkedLine(window.corners(), true, ClipMark.MarkMeaning.WINDOW));
    }

    /** The line that holds a side of a rectangle. */
    private static ClipMark endless(ClipWindow sides, int side, ClipMark.MarkMeaning ink) {
        double far = FAR * sides.unit();
        double x = side == 1 ? sides.xmax() : sides.xmin();
        double y = side == 2 ? sides.ymax() : sides.ymin();
        return side % 2 == 0
                ? ClipMark.MarkedLine.of(
                        new double[] {sides.xmin() - far, y, sides.xmax() + far, y}, ink)
                : ClipMark.MarkedLine.of(
                        new double[] {x, sides.ymin() - far, x, sides.ymax() + far}, ink);
    }

    /** Draws the codes of the nine regions. */
    private void regions(ClipWindow w) {
        double[] xs = {Double.NEGATIVE_INFINITY, w.xmin(), w.xmax(), Double.POSITIVE_INFINITY};
        double[] ys = {Double.NEGATIVE_INFINITY, w.ymin(), w.ymax(), Double.POSITIVE_INFINITY};
        for (int column = 0; column < 3; column++)
            for (int row = 0; row < 3; row++)
                add(
                        new ClipMark.Region(
                                xs[column],
                                ys[row],
                                xs[column + 1],
                                ys[row + 1],
                                Codes.bits(code(w, column, row), 4)));
    }

    /** The code of any point of a region: beyond the sides by a window's size or half inside. */
    private static int code(ClipWindow w, int column, int row) {
        double[] xs = {w.xmin() - w.unit(), w.xmin(), w.xmax() + w.unit()};
        double[] ys = {w.ymin() - w.unit(), w.ymin(), w.ymax() + w.unit()};
        return w.code(xs[column], ys[row]);
    }

    /** Draws the rests of the segments before one. */
    private void parts(Clipping clipping, int before) {
        for (Clipping.ClipPart part : clipping.parts())
            if (part.item() < before)
                add(ClipMark.MarkedLine.of(part.coordinates(), ClipMark.MarkMeaning.LEFT));
    }

    private void step(Clipping clipping, ClipStep step) {
        parts(clipping, step.item());
        if (step.border() >= 0) add(tested(step.border()));
        add(ClipMark.MarkedLine.of(step.left(), ClipMark.MarkMeaning.STEP));
        double[] ends = scene.segments().get(step.item()).ends();
        if (step.places().length > 0)
            add(
                    new ClipMark.MarkedSign(
                            new ClipPoint(step.places()[0], step.places()[1]),
                            ends[2] - ends[0],
                            ends[3] - ends[1],
                            shape(step.passing()),
                            Codes.decision(clipping.decidesByCode(), step, locale)));
    }

    static ClipMark.SignShape shape(ClipStep.Passing passing) {
        return switch (passing) {
            case ENTERING -> ClipMark.SignShape.ENTERING;
            case LEAVING -> ClipMark.SignShape.LEAVING;
            case BOTH, NONE -> ClipMark.SignShape.TESTED;
        };
    }

    private ClipMark tested(int border) {
        if (scene.window().upright())
            return endless(scene.window().rectangle(), border, ClipMark.MarkMeaning.TESTED);
        return ClipMark.MarkedLine.of(
                PolygonDrawing.side(scene.window(), border), ClipMark.MarkMeaning.TESTED);
    }
}
