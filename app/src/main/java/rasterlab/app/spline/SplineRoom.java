package rasterlab.app.spline;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.spline.exact.CurveTask;
import rasterlab.engine.spline.function.SplineProblem;

/** The lab of curves by control points and of functions through knots. */
public final class SplineRoom implements LabRoom<SplineLabModel> {
    @Override
    public String name() {
        return "spline";
    }

    @Override
    public SplineLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new SplineLabModel(own, events, onFailure);
    }

    @Override
    public void keep(SplineLabModel model, Map<String, Kept<?>> kept) {
        kept.put("spline", model);
        kept.put("spline.curve", model.curve());
        kept.put("spline.function", model.function());
    }

    @Override
    public void close(SplineLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(SplineLabModel model, Surroundings around) {
        return new SplinePanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<SplineLabModel>> cards() {
        return List.of(
                card(
                        "curve",
                        TopicBinding.<SplineLabModel>inTurn(
                                        lab -> lab.curve().history(),
                                        (lab, input) -> {
                                            lab.show(SplineMode.CURVE);
                                            lab.curve().show((CurveTask) input);
                                        },
                                        (lab, method) -> lab.curve().chooseMethod(method))
                                .withOwn(
                                        lab -> lab.curve().history(),
                                        SplineRoom::enterCurve,
                                        (lab, method) -> lab.curve().chooseMethod(method),
                                        (lab, method) -> lab.curve().compareWith(method))
                                .writing(
                                        "curve",
                                        lab ->
                                                shown(
                                                        lab,
                                                        SplineMode.CURVE,
                                                        CurveCommand.of(
                                                                lab.curve().state().choice())))),
                card(
                        "spline-function",
                        TopicBinding.<SplineLabModel>inTurn(
                                        lab -> lab.function().history(),
                                        (lab, input) -> {
                                            lab.show(SplineMode.FUNCTION);
                                            lab.function().show((SplineProblem) input);
                                        },
                                        (lab, method) -> lab.function().chooseMethod(method))
                                .withOwn(
                                        lab -> lab.function().history(),
                                        lab -> lab.show(SplineMode.FUNCTION),
                                        (lab, method) -> lab.function().chooseMethod(method),
                                        (lab, method) -> lab.function().compareWith(method))
                                .writing(
                                        "spline-function",
                                        lab ->
                                                shown(
                                                        lab,
                                                        SplineMode.FUNCTION,
                                                        FunctionCommand.of(
                                                                lab.function().state())))));
    }

    private static void enterCurve(SplineLabModel lab) {
        lab.show(SplineMode.CURVE);
        lab.curve().askWhatOwnAnswers();
    }

    private static Optional<String> shown(SplineLabModel lab, SplineMode mode, String command) {
        return lab.mode() == mode ? Optional.of(command) : Optional.empty();
    }

    private TopicCard<SplineLabModel> card(String topic, TopicBinding<SplineLabModel> way) {
        return new TopicCard<>(topic, this, SplineColors.OWN, way);
    }

    @Override
    public List<LabShot<SplineLabModel>> shots() {
        return List.of(
                LabShot.first("spline"),
                new LabShot<>("function", lab -> lab.show(SplineMode.FUNCTION)));
    }
}
