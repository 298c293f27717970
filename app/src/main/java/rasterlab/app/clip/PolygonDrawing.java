package rasterlab.app.clip;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.clip.outcome.ClipStep;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.outcome.Edges;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.app.clip.scene.PlaneFigures;
import rasterlab.app.clip.scene.PolygonClipScene;
import rasterlab.app.clip.scene.ShownWindow;
import rasterlab.engine.clip.polygon.ConvexWindow;

/** The picture of a polygon in a window. */
final class PolygonDrawing {
    /** How far a side is continued beyond its corners, in its lengths. */
    private static final double BEYOND = 100;

    private final PolygonClipScene scene;
    private final List<ClipMark> drawn = new ArrayList<>();

    private PolygonDrawing(PolygonClipScene scene) {
        this.scene = scene;
    }

    /**
     * @param step as {@link ClipLabState#step}
     * @param wrong marked when the result is shown
     */
    static List<ClipMark> of(
            PolygonClipScene scene, Clipping clipping, int step, List<ClipMark> wrong) {
        var drawing = new PolygonDrawing(scene);
        drawing.add(new ClipMark.MarkedArea(scene.window().corners(), ClipMark.MarkMeaning.WINDOW));
        drawing.add(new ClipMark.MarkedArea(scene.subject(), ClipMark.MarkMeaning.GIVEN));
        drawing.add(
                new ClipMark.MarkedLine(
                        scene.window().corners(), true, ClipMark.MarkMeaning.WINDOW));
        drawing.add(new ClipMark.MarkedLine(scene.subject(), true, ClipMark.MarkMeaning.GIVEN));
        boolean finished = step > clipping.steps().size();
        if (finished) drawing.pieces(clipping);
        else if (step > 0) drawing.step(clipping.steps().get(step - 1));
        if (finished) drawing.drawn.addAll(wrong);
        return drawing.drawn;
    }

    private void add(ClipMark one) {
        drawn.add(one);
    }

    private void pieces(Clipping clipping) {
        for (Clipping.ClipPart part : clipping.parts()) {
            List<ClipPoint> corners = PlaneFigures.points(part.coordinates());
            add(new ClipMark.MarkedArea(corners, ClipMark.MarkMeaning.LEFT));
            add(new ClipMark.MarkedLine(corners, true, ClipMark.MarkMeaning.LEFT));
        }
    }

    private void step(ClipStep step) {
        List<ClipPoint> corners = PlaneFigures.points(step.left());
        boolean open = step.border() < 0;
        if (!open) add(new ClipMark.MarkedArea(corners, ClipMark.MarkMeaning.LEFT));
        if (!open)
            add(
                    ClipMark.MarkedLine.of(
                            continued(side(scene.window(), step.border())),
                            ClipMark.MarkMeaning.TESTED));
        add(new ClipMark.MarkedLine(corners, !open, ClipMark.MarkMeaning.STEP));
        if (step.passing() == ClipStep.Passing.BOTH) passage(step.places());
    }

    private void passage(double[] places) {
        sign(places, 0, ClipMark.SignShape.ENTERING);
        sign(places, 2, ClipMark.SignShape.LEAVING);
    }

    private void sign(double[] places, int at, ClipMark.SignShape shape) {
        var place = new ClipPoint(places[at], places[at + 1]);
        double[] way = inward(place);
        double sense = shape == ClipMark.SignShape.ENTERING ? 1 : -1;
        add(new ClipMark.MarkedSign(place, sense * way[0], sense * way[1], shape, ""));
    }

    /** The direction from a place on the rim towards the middle of the window. */
    private double[] inward(ClipPoint place) {
        double[] xy = scene.window().xy();
        double x = 0;
        double y = 0;
        for (int i = 0; i < xy.length; i += 2) {
            x += 2 * xy[i] / xy.length;
            y += 2 * xy[i + 1] / xy.length;
        }
        return new double[] {x - place.x(), y - place.y()};
    }

    /** The ends of a side of a convex window, counted as its methods do. */
    static double[] side(ShownWindow window, int side) {
        return Edges.around(ConvexWindow.of(window.xy()).xy()).get(side);
    }

    private static double[] continued(double[] side) {
        double dx = BEYOND * (side[2] - side[0]);
        double dy = BEYOND * (side[3] - side[1]);
        return new double[] {side[0] - dx, side[1] - dy, side[2] + dx, side[3] + dy};
    }
}
