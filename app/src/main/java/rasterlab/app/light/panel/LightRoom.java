package rasterlab.app.light.panel;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicInput;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.TopicBodies;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowLabModel;
import rasterlab.app.row.RowTopic;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.shade.ShadeTopic;
import rasterlab.engine.study.Topic;

/** The lab of light, colour and texture. */
public final class LightRoom implements LabRoom<LightLabModel> {
    @Override
    public String name() {
        return "light";
    }

    @Override
    public LightLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new LightLabModel(own, events, onFailure);
    }

    @Override
    public void keep(LightLabModel model, Map<String, Kept<?>> kept) {
        kept.put("light", model);
        kept.put("light.file", model.keptFile());
        kept.put("light.rows", model.rows());
        kept.put("light.rows.open", model.rows().keptOpen());
    }

    @Override
    public void close(LightLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(LightLabModel model, Surroundings around) {
        return new LightPanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<LightLabModel>> cards() {
        return Stream.concat(lit(), RowLabModel.textureTopics().stream().map(this::row)).toList();
    }

    private Stream<TopicCard<LightLabModel>> lit() {
        return Stream.of(
                card("color", colors()),
                lit(new ShadeTopic(), Set.of("phong", "blinn-phong"), LitInputs::point),
                lit(new FaceTopic(), Set.of("flat", "gouraud", "phong"), LitInputs::face),
                lit(
                        new NormalsTopic(),
                        Set.of("plain-textbook", "plain", "area", "angle"),
                        state -> Optional.of(LitInputs.body(state.choice()))));
    }

    private TopicBinding<LightLabModel> colors() {
        return lit("color", Set.of("formula"))
                .withOwn(
                        LightLabModel::history,
                        LightLabModel::enterColors,
                        (lab, name) -> lab.color(color -> color.withMethod(name)),
                        (lab, name) -> {})
                .writing(
                        writing(
                                new ColorTopic(),
                                state ->
                                        state.colors()
                                                ? Optional.of(LitInputs.color(state.color()))
                                                : Optional.empty()));
    }

    private TopicCard<LightLabModel> card(String topic, TopicBinding<LightLabModel> way) {
        return new TopicCard<>(topic, this, LightColors.OWN, way);
    }

    /**
     * @param drawnBy by which of the topic's methods the lab draws
     * @param lit what is lit as an input of the topic; empty where it is none
     */
    private <I> TopicCard<LightLabModel> lit(
            Topic<?, I, ?> topic, Set<String> drawnBy, Function<LightLabState, Optional<I>> lit) {
        TopicBinding<LightLabModel> way =
                lit(topic.name(), drawnBy)
                        .showingOwn((lab, given, beside) -> own(lab, topic.name(), given, beside))
                        .writing(
                                writing(
                                        topic,
                                        state ->
                                                state.colors()
                                                        ? Optional.empty()
                                                        : lit.apply(state)));
        return card(topic.name(), way);
    }

    /** Lights by the user's own program, all in one change. */
    private static void own(
            LightLabModel lab, String topic, Optional<TopicInput> input, String beside) {
        lab.history().asOne(() -> lab.showOwn(topic, input.map(TopicInput::input), beside));
    }

    private static <I> TopicBinding.InputWriter<LightLabModel> writing(
            Topic<?, I, ?> topic, Function<LightLabState, Optional<I>> shown) {
        return lab ->
                lab.rows().open()
                        ? Optional.empty()
                        : shown.apply(lab.state()).map(input -> GivenInput.name(topic, input));
    }

    /**
     * @param drawnBy by which of the topic's methods the lab draws
     */
    private static TopicBinding<LightLabModel> lit(String topic, Set<String> drawnBy) {
        return TopicBinding.noted(
                (lab, input, method) -> {
                    lab.rows().close();
                    lab.show(topic, input.hazard(), input.input(), method);
                },
                new TopicBinding.PictureNotes<>(
                        (lab, input, method) -> TopicBodies.shownDifferences(input.input(), method),
                        method -> method.equals(OwnMethods.NAME) || drawnBy.contains(method),
                        LightLabModel::tell));
    }

    private TopicCard<LightLabModel> row(String topic) {
        return RowTopic.card(this, topic, LightLabModel::rows);
    }

    @Override
    public List<LabShot<LightLabModel>> shots() {
        return List.of(
                new LabShot<>("light", lab -> lab.drawNormals(true)),
                new LabShot<>("colours", lab -> lab.showColors(true)),
                new LabShot<>(
                        "texture-rows",
                        lab -> lab.rows().show("texture-mapping", "floor", "affine")),
                new LabShot<>(
                        "filter-rows",
                        lab -> lab.rows().show("texture-filter", "aliasing", "nearest")));
    }
}
