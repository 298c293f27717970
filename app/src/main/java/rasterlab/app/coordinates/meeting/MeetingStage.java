package rasterlab.app.coordinates.meeting;

import java.awt.CardLayout;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.coordinates.figure.Box;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.Spot;
import rasterlab.app.language.Texts;
import rasterlab.engine.geometry.Vector;

/** The picture along the plane, in which both points of the line can be dragged. */
final class MeetingStage extends JPanel implements AutoCloseable {
    private static final long serialVersionUID = 1L;

    private final transient MeetingLabModel model;
    private final transient Texts texts;
    private final transient MeetingReadings readings;
    private final PlaneView view;

    MeetingStage(MeetingLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(new CardLayout());
        this.model = model;
        this.texts = texts;
        readings = new MeetingReadings(model, texts);
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
        Figure figure = MeetingFigure.of(model.scene(), model.view());
        view.show(
                figure,
                List.of(
                        point(MeetingLabModel.Grip.FROM, model.choice().line().from()),
                        point(MeetingLabModel.Grip.THROUGH, model.choice().line().through())),
                readings.note(),
                Box.around(figure.marks()),
                model.arrangement());
    }

    private PlanePoint point(MeetingLabModel.Grip grip, Vector at) {
        Spot spot = model.view().spot(at);
        boolean from = grip == MeetingLabModel.Grip.FROM;
        return new PlanePoint(
                grip.name(),
                spot.x(),
                spot.y(),
                from ? PlanePoint.Form.CIRCLE : PlanePoint.Form.SQUARE,
                from ? "p₁" : "p₂",
                texts.text("point.said", from ? "p₁" : "p₂", readings.vector(at)));
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
            model.move(MeetingLabModel.Grip.valueOf(point), x, y);
        }
    }
}
