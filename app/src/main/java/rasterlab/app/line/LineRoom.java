package rasterlab.app.line;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.line.figure.FigureCommand;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.circle.Circle;
import rasterlab.engine.circle.Ellipse;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;

/** The lab of segments, circles and ellipses. */
public final class LineRoom implements LabRoom<LineLabModel> {
    @Override
    public String name() {
        return "line";
    }

    @Override
    public LineLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new LineLabModel(new LineTopic(), own, events, onFailure);
    }

    @Override
    public void keep(LineLabModel model, Map<String, Kept<?>> kept) {
        kept.put("line", model);
        kept.put("line.tried", model.keptTried());
        kept.put("line.figures", model.figures());
        kept.put("line.mode", model.keptMode());
    }

    @Override
    public void close(LineLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(LineLabModel model, Surroundings around) {
        return new LinePanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<LineLabModel>> cards() {
        return List.of(
                new TopicCard<>("line", this, LineColors.OWN, segments()),
                figure(
                        "circle",
                        LineMode.CIRCLE,
                        (lab, input) -> lab.figures().show((Circle) input)),
                figure(
                        "ellipse",
                        LineMode.ELLIPSE,
                        (lab, input) -> lab.figures().show((Ellipse) input)));
    }

    private static TopicBinding<LineLabModel> segments() {
        return TopicBinding.<LineLabModel>inTurn(
                        LineLabModel::history,
                        (lab, input) -> {
                            lab.chooseMode(LineMode.SEGMENT);
                            lab.show((Segment) input);
                        },
                        LineLabModel::chooseMethod)
                .reading(
                        new TopicBinding.Cases<>(
                                LineInput::read,
                                (lab, input, method, drawn) ->
                                        lab.showTried((Segment) input, method, drawn)))
                .writing("line", LineRoom::segmentCommand)
                .withOwn(
                        LineLabModel::history,
                        lab -> lab.chooseMode(LineMode.SEGMENT),
                        LineLabModel::chooseMethod,
                        LineLabModel::compareWith);
    }

    private static Optional<String> segmentCommand(LineLabModel lab) {
        return lab.mode() == LineMode.SEGMENT
                ? Optional.of(LineCommand.of(lab.state().choice()))
                : Optional.empty();
    }

    private TopicCard<LineLabModel> figure(
            String topic, LineMode mode, BiConsumer<LineLabModel, Object> show) {
        return new TopicCard<>(
                topic,
                this,
                LineColors.OWN,
                TopicBinding.<LineLabModel>inTurn(
                                lab -> lab.figures().history(),
                                (lab, input) -> {
                                    lab.chooseMode(mode);
                                    show.accept(lab, input);
                                },
                                (lab, method) -> lab.figures().chooseMethod(method))
                        .writing(topic, lab -> FigureCommand.of(lab.figures().state().scene()))
                        .withOwn(
                                lab -> lab.figures().history(),
                                lab -> lab.chooseMode(mode),
                                (lab, method) -> lab.figures().chooseMethod(method),
                                (lab, method) -> lab.figures().compareWith(method)));
    }

    @Override
    public List<LabShot<LineLabModel>> shots() {
        return List.of(
                new LabShot<>("line", LineRoom::showWrongPixels),
                new LabShot<>("circle", LineRoom::showParametricEllipse),
                new LabShot<>("brightness", lab -> lab.chooseMode(LineMode.BRIGHTNESS)));
    }

    /** Shows a faulty method where it fails. */
    private static void showWrongPixels(LineLabModel lab) {
        lab.show(new Segment(17, 9, 2, 3));
        lab.chooseMethod("bresenham-textbook");
    }

    private static void showParametricEllipse(LineLabModel lab) {
        lab.chooseMode(LineMode.ELLIPSE);
        lab.figures().chooseMethod("parametric");
        lab.figures().compareWith("midpoint");
    }
}
