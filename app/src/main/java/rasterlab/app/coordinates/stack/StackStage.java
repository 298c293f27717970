package rasterlab.app.coordinates.stack;

import java.awt.CardLayout;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.coordinates.figure.Box;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.language.Texts;

/** The picture that the program draws; its origin can be dragged to turn it. */
final class StackStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private static final double DEGREES_PER_DOT = 0.5;

    private final transient StackLabModel model;
    private final transient Texts texts;
    private final PlaneView view;
    private transient Rectangle2D everything = new Rectangle2D.Double(0, 0, 1, 1);

    StackStage(StackLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(new CardLayout());
        this.model = model;
        this.texts = texts;
        setOpaque(false);
        view =
                new PlaneView(
                        PlaneAxes.GEOMETRY,
                        Texts.of("canvas", texts.language()),
                        texts.text("stage"),
                        new Edits(),
                        () -> {},
                        onFailure);
        add(view, "stage");
        refresh();
    }

    PlaneView shown() {
        return view;
    }

    void refresh() {
        StackChoice choice = model.choice();
        StackScene whole = StackScene.of(choice.commands(), model.last());
        Figure figure = StackFigure.of(model.scene(), choice.viewpoint());
        everything = Box.around(StackFigure.of(whole, choice.viewpoint()).marks());
        everything.add(Box.around(figure.marks()));
        view.show(
                figure,
                List.of(
                        new PlanePoint(
                                "turn", 0, 0, PlanePoint.Form.CIRCLE, "", texts.text("turn.said"))),
                note(),
                everything,
                model.arrangement());
    }

    private String note() {
        StackScene.Error error = model.scene().errors().get(model.step() - 1);
        return error == null ? "" : StackReadings.error(error, model.scene(), texts);
    }

    void focusPoint() {
        view.focusPoint();
    }

    /** Ends the thread that paints. */
    @Override
    public void close() {
        view.close();
    }

    private final class Edits implements PlaneEdits {
        @Override
        public void beginDrag() {
            model.beginDrag();
        }

        @Override
        public void endDrag() {
            model.endDrag();
        }

        @Override
        public void move(String point, double x, double y) {
            double size = Math.max(everything.getWidth(), everything.getHeight());
            model.turn(x / size, y / size);
        }

        @Override
        public boolean turn(int viewRight, int viewDown) {
            model.turnBy(viewRight * DEGREES_PER_DOT, viewDown * DEGREES_PER_DOT);
            return true;
        }
    }
}
