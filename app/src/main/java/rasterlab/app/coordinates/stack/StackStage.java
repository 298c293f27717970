package rasterlab.app.coordinates.stack;

import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.coordinates.figure.PlaneStage;
import rasterlab.app.language.Texts;

/** The picture that the program draws; its origin can be dragged to turn it. */
final class StackStage extends PlaneStage {
    private static final long serialVersionUID = 1L;

    private static final double DEGREES_PER_DOT = 0.5;

    private final transient StackLabModel model;
    private final transient Texts texts;
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);

    StackStage(StackLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(model, texts, onFailure);
        this.model = model;
        this.texts = texts;
        refresh();
    }

    /** Shows the model's present state. */
    void refresh() {
        StackChoice choice = model.choice();
        StackScene whole = StackScene.of(choice.commands(), model.last());
        Figure figure = StackFigure.of(model.scene(), choice.viewpoint());
        everything = MarkBounds.around(StackFigure.of(whole, choice.viewpoint()).marks());
        everything.add(MarkBounds.around(figure.marks()));
        shown().show(
                        figure,
                        List.of(
                                new PlanePoint(
                                        "turn",
                                        0,
                                        0,
                                        PlanePoint.HandleShape.CIRCLE,
                                        "",
                                        texts.text("turn.said"))),
                        note(),
                        everything,
                        model.arrangement());
    }

    private String note() {
        StackScene.Error error = model.scene().errors().get(model.step() - 1);
        return error == null ? "" : StackReadings.error(error, model.scene(), texts);
    }

    @Override
    protected void move(String point, double x, double y) {
        double size = Math.max(everything.getWidth(), everything.getHeight());
        model.turn(x / size, y / size);
    }

    @Override
    protected boolean turn(int viewRight, int viewDown) {
        model.turnBy(viewRight * DEGREES_PER_DOT, viewDown * DEGREES_PER_DOT);
        return true;
    }
}
