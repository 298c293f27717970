package rasterlab.app.visibility;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicInput;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.row.RowTopic;
import rasterlab.app.visibility.scene.SceneInputs;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.TopicView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.order.Sight;

/** The lab of hidden surfaces. */
public final class VisibilityRoom implements LabRoom<VisibilityLabModel> {
    /** Methods of the other topics about hidden surfaces, by what draws by them. */
    private static final Map<String, String> DRAWN_BY =
            Map.of(
                    "mean-z-textbook", "painter-textbook",
                    "mean-z", "painter",
                    "convex-segment-textbook", "convex",
                    "convex-segment", "convex");

    @Override
    public String name() {
        return "visibility";
    }

    @Override
    public VisibilityLabModel model(
            Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new VisibilityLabModel(own, PictureMaker.by(new Renderer()), events, onFailure);
    }

    @Override
    public void keep(VisibilityLabModel model, Map<String, Kept<?>> kept) {
        kept.put("visibility", model);
        kept.put("visibility.files", model.keptFiles());
        kept.put("visibility.rows", model.rows());
        kept.put("visibility.rows.open", model.rows().keptOpen());
    }

    @Override
    public void close(VisibilityLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(VisibilityLabModel model, Surroundings around) {
        return new VisibilityPanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<VisibilityLabModel>> cards() {
        return Stream.concat(scenes(), RowLabModel.depthTopics().stream().map(this::row)).toList();
    }

    private Stream<TopicCard<VisibilityLabModel>> scenes() {
        return Stream.of(
                card(
                        new HiddenSurfacesTopic(),
                        (in, method) -> TopicView.of(in.name(), (SurfaceView) in.input(), method),
                        SceneInputs::surfaces),
                drawn(
                        new VisibleFacesTopic(),
                        (in, method) ->
                                TopicView.of(in.name(), (Body) in.input(), method, drawnBy(method)),
                        choice -> Optional.of(SceneInputs.body(choice))),
                drawn(
                        new DepthOrderTopic(),
                        (in, method) ->
                                TopicView.of(
                                        in.name(), (Sight) in.input(), method, drawnBy(method)),
                        choice -> Optional.of(SceneInputs.sight(choice))));
    }

    private TopicCard<VisibilityLabModel> row(String topic) {
        return RowTopic.card(this, topic, VisibilityLabModel::rows);
    }

    private static String drawnBy(String method) {
        return DRAWN_BY.getOrDefault(method, method);
    }

    private <I> TopicCard<VisibilityLabModel> card(
            Topic<?, I, ?> topic,
            BiFunction<TopicInput, String, TopicView> view,
            Function<VisibilityChoice, Optional<I>> seen) {
        return new TopicCard<>(
                topic.name(),
                this,
                VisibilityColors.OWN,
                TopicBinding.<VisibilityLabModel>noted(
                                (lab, input, method) ->
                                        show(lab, view.apply(input, method), input, method),
                                new TopicBinding.PictureNotes<>(
                                        (lab, input, method) ->
                                                view.apply(input, method).differences(),
                                        method -> true,
                                        VisibilityLabModel::tell))
                        .writing(
                                lab ->
                                        lab.rows().open()
                                                ? Optional.empty()
                                                : seen.apply(lab.state().choice())
                                                        .map(
                                                                input ->
                                                                        GivenInput.name(
                                                                                topic, input))));
    }

    private static void show(
            VisibilityLabModel lab, TopicView shown, TopicInput input, String method) {
        lab.rows().close();
        boolean mine = method.equals(OwnMethods.NAME);
        if (mine) lab.enterOwn(input.topic());
        lab.choose(
                old -> {
                    VisibilityChoice next = shown.shown(old).showing(input.input());
                    return mine ? next.withVisibility(method) : next;
                });
    }

    /** A topic whose methods draw scenes; so may the user's own program. */
    private <I> TopicCard<VisibilityLabModel> drawn(
            Topic<?, I, ?> topic,
            BiFunction<TopicInput, String, TopicView> view,
            Function<VisibilityChoice, Optional<I>> seen) {
        TopicCard<VisibilityLabModel> card = card(topic, view, seen);
        TopicBinding.ShowOwn<VisibilityLabModel> showing =
                (lab, input, beside) ->
                        lab.history().asOne(() -> showOwn(lab, topic.name(), input, beside, view));
        return new TopicCard<>(
                card.topic(), card.lab(), card.colors(), card.way().showingOwn(showing));
    }

    /**
     * Shows the whole input, of which methods of the topic would be shown only what they call
     * visible.
     */
    private static void showOwn(
            VisibilityLabModel lab,
            String topic,
            Optional<TopicInput> input,
            String beside,
            BiFunction<TopicInput, String, TopicView> view) {
        lab.enterOwn(topic);
        input.ifPresent(one -> show(lab, view.apply(one, ""), one, ""));
        // The lab leaves the method and returns, since it may be another program now.
        lab.choose(choice -> choice.withVisibility(drawnBy(beside)));
        lab.choose(
                choice ->
                        choice.withVisibility(OwnMethods.NAME)
                                .withComparison(drawnBy(beside))
                                .withView(StageView.COLORS)
                                .withDifference(true));
    }

    @Override
    public List<LabShot<VisibilityLabModel>> shots() {
        return List.of(
                LabShot.first("visibility"),
                new LabShot<>("order", VisibilityRoom::showOrder),
                new LabShot<>(
                        "depth-rows", lab -> lab.rows().show("depth-buffer", "crossing", "z16")));
    }

    /** No order of whole boards is right; the list has the order in which they were drawn. */
    private static void showOrder(VisibilityLabModel lab) {
        lab.compareColors("cyclic-overlap", "painter", "newell");
        lab.watchSteps(true);
    }
}
