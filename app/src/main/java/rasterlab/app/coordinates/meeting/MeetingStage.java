package rasterlab.app.coordinates.meeting;

import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.coordinates.figure.Figure;
import rasterlab.app.coordinates.figure.MarkBounds;
import rasterlab.app.coordinates.figure.PlaneStage;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.language.Texts;
import rasterlab.engine.geometry.Vector;

/** The picture along the plane, in which both points of the line can be dragged. */
final class MeetingStage extends PlaneStage {
    private static final long serialVersionUID = 1L;

    private final transient MeetingLabModel model;
    private final transient Texts texts;
    private final transient MeetingReadings readings;

    MeetingStage(MeetingLabModel model, Texts texts, Consumer<Throwable> onFailure) {
        super(model, texts, onFailure);
        this.model = model;
        this.texts = texts;
        readings = new MeetingReadings(model, texts);
        refresh();
    }

    /** Shows the model's present state. */
    void refresh() {
        Figure figure = MeetingFigure.of(model.scene(), model.view());
        shown().show(
                        figure,
                        List.of(
                                point(
                                        MeetingLabModel.MeetingGrip.FROM,
                                        model.choice().line().from()),
                                point(
                                        MeetingLabModel.MeetingGrip.THROUGH,
                                        model.choice().line().through())),
                        readings.note(),
                        MarkBounds.around(figure.marks()),
                        model.arrangement());
    }

    private PlanePoint point(MeetingLabModel.MeetingGrip grip, Vector at) {
        StagePoint spot = model.view().spot(at);
        boolean from = grip == MeetingLabModel.MeetingGrip.FROM;
        return new PlanePoint(
                grip.name(),
                spot.x(),
                spot.y(),
                from ? PlanePoint.HandleShape.CIRCLE : PlanePoint.HandleShape.SQUARE,
                from ? "p₁" : "p₂",
                texts.text("point.said", from ? "p₁" : "p₂", readings.vector(at)));
    }

    @Override
    protected void move(String point, double x, double y) {
        model.move(MeetingLabModel.MeetingGrip.valueOf(point), x, y);
    }
}
