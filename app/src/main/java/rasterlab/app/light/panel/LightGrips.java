package rasterlab.app.light.panel;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.MarkPlaces;

/** Where the grips lie on the stage, and what dragging one there means. */
public final class LightGrips {
    /** View units from a grip's middle that still take hold of it. */
    private static final double REACH = 12;

    /** View units from a lamp's middle to the ends of its rays. */
    static final int LAMP = 16;

    private final LightLabModel model;

    public LightGrips(LightLabModel model) {
        this.model = model;
    }

    private List<LightGrip> all() {
        var grips = new ArrayList<LightGrip>();
        for (int i = 0; i < model.state().choice().lamps().size(); i++)
            grips.add(new LightGrip(LightGrip.LightGripKind.LAMP, i));
        grips.add(new LightGrip(LightGrip.LightGripKind.POINT, 0));
        grips.add(new LightGrip(LightGrip.LightGripKind.FROM, 0));
        grips.add(new LightGrip(LightGrip.LightGripKind.TO, 0));
        return grips;
    }

    /** The middle of a grip in view units from its picture's corner, kept inside the picture. */
    public static Point2D at(
            LightGrip grip, LightFrame.DrawnFrame drawn, LightChoice choice, Rectangle box) {
        LightChoice.LightMarks line = choice.line();
        var places = new MarkPlaces(box.width, box.height);
        return switch (grip.kind()) {
            case FROM -> new Point2D.Double(places.x(line.fromX()), places.y(line.fromY()));
            case TO -> new Point2D.Double(places.x(line.toX()), places.y(line.toY()));
            case POINT -> new Point2D.Double(places.x(line.atX()), places.y(line.atY()));
            case LAMP -> {
                double[] pixel = pixel(drawn, choice.lamps().get(grip.index()));
                double scale = (double) drawn.width() / box.width;
                yield new Point2D.Double(
                        Math.max(LAMP, Math.min(box.width - LAMP, pixel[0] / scale)),
                        Math.max(LAMP, Math.min(box.height - LAMP, pixel[1] / scale)));
            }
        };
    }

    public static double[] pixel(LightFrame.DrawnFrame drawn, Lamp lamp) {
        return drawn.places().toPicture(lamp.x(), lamp.y(), lamp.z());
    }

    /** The grip under the mouse: the selected lamp before others. */
    Optional<LightGrip> under(Point view, StagePlan plan) {
        LightLabState state = model.state();
        if (state.drawn().isEmpty()) return Optional.empty();
        Rectangle box = plan.picture(plan.pictureAt(view.x));
        if (!box.contains(view)) return Optional.empty();
        LightGrip best = null;
        double nearest = REACH;
        for (LightGrip grip : all()) {
            Point2D at = at(grip, state.drawn().get(), state.choice(), box);
            double away = at.distance(view.x - box.x, view.y - box.y);
            boolean selected =
                    grip.kind() == LightGrip.LightGripKind.LAMP
                            && grip.index() == state.choice().selected();
            if (away < nearest || selected && away < REACH) {
                nearest = selected ? 0 : away;
                best = grip;
            }
        }
        return Optional.ofNullable(best);
    }

    /** Moves a grip to a place of the stage; a lamp keeps its depth. */
    public void drag(LightGrip grip, Point view, StagePlan plan) {
        Rectangle box = plan.picture(plan.pictureAt(view.x));
        if (grip.kind() == LightGrip.LightGripKind.LAMP) {
            double x = within((double) (view.x - box.x) / box.width);
            double y = within((double) (view.y - box.y) / box.height);
            moveLamp(grip.index(), x, y);
            return;
        }
        var places = new MarkPlaces(box.width, box.height);
        double x = places.markX(view.x - box.x);
        double y = places.markY(view.y - box.y);
        model.choose(choice -> choice.with(moved(choice.line(), grip.kind(), x, y)));
    }

    private static LightChoice.LightMarks moved(
            LightChoice.LightMarks line, LightGrip.LightGripKind kind, double x, double y) {
        return switch (kind) {
            case FROM ->
                    new LightChoice.LightMarks(
                            x, y, line.toX(), line.toY(), line.atX(), line.atY());
            case TO ->
                    new LightChoice.LightMarks(
                            line.fromX(), line.fromY(), x, y, line.atX(), line.atY());
            case POINT, LAMP ->
                    new LightChoice.LightMarks(
                            line.fromX(), line.fromY(), line.toX(), line.toY(), x, y);
        };
    }

    private void moveLamp(int index, double x, double y) {
        if (model.state().drawn().isEmpty()) return;
        LightFrame.DrawnFrame drawn = model.state().drawn().get();
        Lamp lamp = model.state().choice().lamps().get(index);
        double depth = pixel(drawn, lamp)[2];
        place(index, drawn.places().toWorld(x * drawn.width(), y * drawn.height(), depth));
    }

    /**
     * Moves the selected lamp on the picture, and away from the eye.
     *
     * @param right pixels
     * @param down pixels
     * @param away factor of its depth
     */
    public void nudge(double right, double down, double away) {
        if (model.state().drawn().isEmpty()) return;
        LightFrame.DrawnFrame drawn = model.state().drawn().get();
        LightChoice choice = model.state().choice();
        double[] pixel = pixel(drawn, choice.lamp());
        place(
                choice.selected(),
                drawn.places().toWorld(pixel[0] + right, pixel[1] + down, pixel[2] * away));
    }

    private void place(int index, double[] world) {
        model.choose(
                choice -> {
                    Lamp lamp = choice.lamps().get(index);
                    return choice.withLamp(
                            index,
                            lamp.moved(limited(world[0]), limited(world[1]), limited(world[2])));
                });
    }

    /** Rounds to whole units, near enough to be found again. */
    private static double limited(double world) {
        return Math.rint(Math.max(-LampControls.FAR, Math.min(LampControls.FAR, world)));
    }

    private static double within(double share) {
        return Math.max(0, Math.min(1, share));
    }
}
