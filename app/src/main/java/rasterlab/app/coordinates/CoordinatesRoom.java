package rasterlab.app.coordinates;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.geometry.meeting.PlaneAndLines;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.rotate.Turns;

/** The lab of coordinates: matrices, rotations, views, a line and a plane. */
public final class CoordinatesRoom implements LabRoom<CoordinatesLabModel> {
    @Override
    public String name() {
        return "coordinates";
    }

    @Override
    public CoordinatesLabModel model(
            Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new CoordinatesLabModel(own, events, onFailure);
    }

    @Override
    public void keep(CoordinatesLabModel model, Map<String, Kept<?>> kept) {
        kept.put("coordinates", model);
        kept.put("coordinates.views", model.views());
        kept.put("coordinates.transformations", model.transformations());
        kept.put("coordinates.stack", model.stack());
        kept.put("coordinates.rotation", model.rotation());
        kept.put("coordinates.meeting", model.meeting());
    }

    @Override
    public void close(CoordinatesLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(CoordinatesLabModel model, Surroundings around) {
        return new CoordinatesPanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<CoordinatesLabModel>> cards() {
        return List.of(
                new TopicCard<>("rotate", this, FigureColors.OWN, rotations()),
                new TopicCard<>("matrix", this, FigureColors.OWN, matrices()),
                new TopicCard<>("line-plane", this, FigureColors.OWN, meetings()),
                new TopicCard<>("transform", this, FigureColors.OWN, points("transform")),
                new TopicCard<>("view", this, FigureColors.OWN, points("view")),
                new TopicCard<>("rotate-axis", this, FigureColors.OWN, points("rotate-axis")));
    }

    private static TopicBinding<CoordinatesLabModel> rotations() {
        return TopicBinding.<CoordinatesLabModel>inTurn(
                        lab -> lab.rotation().history(),
                        (lab, input) -> {
                            lab.show(CoordinatesMode.ROTATION);
                            lab.rotation().show((Turns) input);
                        },
                        (lab, method) -> lab.rotation().chooseMethod(method))
                .writing(
                        "rotate",
                        lab ->
                                lab.in(CoordinatesMode.ROTATION)
                                        .map(shown -> shown.rotation().command()))
                .withOwn(
                        lab -> lab.rotation().history(),
                        lab -> lab.show(CoordinatesMode.ROTATION),
                        (lab, method) -> lab.rotation().chooseMethod(method),
                        (lab, method) -> {});
    }

    private static TopicBinding<CoordinatesLabModel> matrices() {
        return TopicBinding.<CoordinatesLabModel>inTurn(
                        lab -> lab.transformations().history(),
                        (lab, input) -> {
                            lab.show(CoordinatesMode.TRANSFORMATIONS);
                            lab.transformations().show((MatrixCall) input);
                        },
                        (lab, method) -> lab.transformations().chooseMethod(method))
                .writing(listed("matrix"));
    }

    private static TopicBinding<CoordinatesLabModel> meetings() {
        return TopicBinding.<CoordinatesLabModel>inTurn(
                        lab -> lab.meeting().history(),
                        (lab, input) -> {
                            lab.show(CoordinatesMode.MEETING);
                            lab.meeting().show((PlaneAndLines) input);
                        },
                        (lab, method) -> lab.meeting().chooseMethod(method))
                .writing(
                        "line-plane",
                        lab ->
                                lab.in(CoordinatesMode.MEETING)
                                        .flatMap(shown -> shown.meeting().command()));
    }

    /** Tells the list of matrices, and the points that go through them, as an input. */
    private static TopicBinding.InputWriter<CoordinatesLabModel> listed(String topic) {
        return lab ->
                lab.in(CoordinatesMode.TRANSFORMATIONS)
                        .flatMap(shown -> shown.transformations().input(topic));
    }

    /** Points of space, beside what the method makes of them. */
    private static TopicBinding<CoordinatesLabModel> points(String topic) {
        return TopicBinding.<CoordinatesLabModel>whole(
                        (lab, input, method) -> {
                            lab.show(CoordinatesMode.TRANSFORMATIONS);
                            if (input.hazard().isEmpty())
                                lab.transformations().show(topic, input.input(), method);
                            else lab.transformations().show(topic, input.hazard(), method);
                        })
                .writing(listed(topic))
                .withOwn(
                        lab -> lab.transformations().history(),
                        lab -> {
                            lab.show(CoordinatesMode.TRANSFORMATIONS);
                            lab.transformations().enter(topic);
                        },
                        (lab, method) -> lab.transformations().tryMethod(method),
                        (lab, method) -> {});
    }

    @Override
    public List<LabShot<CoordinatesLabModel>> shots() {
        return List.of(
                LabShot.first("coordinates"),
                shot("transformations", CoordinatesMode.TRANSFORMATIONS),
                shot("stack", CoordinatesMode.STACK),
                shot("rotation", CoordinatesMode.ROTATION),
                shot("meeting", CoordinatesMode.MEETING));
    }

    private static LabShot<CoordinatesLabModel> shot(String name, CoordinatesMode mode) {
        return new LabShot<>(name, lab -> lab.show(mode));
    }
}
