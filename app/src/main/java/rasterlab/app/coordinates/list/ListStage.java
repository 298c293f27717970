package rasterlab.app.coordinates.list;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.Shown;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.coordinates.figure.PlaneStage;
import rasterlab.app.language.Texts;

/** The picture of a list; in the plane the subject's corners can be dragged. */
final class ListStage extends PlaneStage {
    private static final long serialVersionUID = 1L;

    private static final double DEGREES_PER_DOT = 0.5;

    /** The number of a subject's points that are its corners. */
    private static final int CORNERS = 4;

    private final transient ListLabModel model;
    private final transient Texts texts;
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);

    ListStage(ListLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(model, texts, model::settle, onFailure);
        this.model = model;
        this.texts = texts;
        refresh();
    }

    /** Shows the model's present state. */
    void refresh() {
        Figure figure = figure(model.step());
        everything = MarkBounds.around(figure(model.last()).marks());
        everything.add(MarkBounds.around(figure.marks()));
        int known = model.trial().isPresent() ? 1 : 0;
        shown().show(figure, points(), note(), everything, 2 * model.arrangement() + known);
    }

    /** The end of what is tried as the method has it, once that is known. */
    private Figure figure(int step) {
        if (model.choice().trial().isEmpty() || step < model.last())
            return ListFigure.of(model.scene(), step);
        return model.trial()
                .map(tried -> TrialFigure.of(tried, model.choice(), texts.language()))
                .orElseGet(() -> ListFigure.of(model.scene(), 0));
    }

    private String note() {
        if (model.choice().trial().isPresent()) return new TrialReadings(model, texts).note();
        ListScene scene = model.scene();
        if (scene.isRefused()) return ListReadings.refusal(scene, texts);
        return scene.wrong() ? texts.text("note.wrong") : "";
    }

    private List<PlanePoint> points() {
        return model.choice().dimension() == 2 ? corners() : List.of(grip());
    }

    private List<PlanePoint> corners() {
        var points = new ArrayList<PlanePoint>();
        List<Double> numbers = model.choice().points();
        for (int i = 0; i < Math.min(CORNERS, numbers.size() / 2); i++) {
            double x = numbers.get(2 * i);
            double y = numbers.get(2 * i + 1);
            String said = texts.text("corner.said", i + 1, Shown.point(x, y, texts.locale()));
            points.add(
                    new PlanePoint("corner." + i, x, y, PlanePoint.HandleShape.DIAMOND, "", said));
        }
        return points;
    }

    /** The origin, by which space is turned. */
    private PlanePoint grip() {
        return new PlanePoint(
                "turn", 0, 0, PlanePoint.HandleShape.CIRCLE, "", texts.text("turn.said"));
    }

    @Override
    protected void move(String point, double x, double y) {
        if (point.startsWith("corner.")) {
            model.movePoint(Integer.parseInt(point.substring("corner.".length())), x, y);
            return;
        }
        double size = Math.max(everything.getWidth(), everything.getHeight());
        model.turn(x / size, y / size);
    }

    @Override
    protected boolean turn(int viewRight, int viewDown) {
        if (model.choice().dimension() == 2) return false;
        model.turnBy(viewRight * DEGREES_PER_DOT, viewDown * DEGREES_PER_DOT);
        return true;
    }
}
