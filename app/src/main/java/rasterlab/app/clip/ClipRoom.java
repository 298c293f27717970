package rasterlab.app.clip;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.mine.OwnMethods;

/** The lab of clipping: segments, a polygon, a view volume. */
public final class ClipRoom implements LabRoom<ClipLabModel> {
    @Override
    public String name() {
        return "clip";
    }

    @Override
    public ClipLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new ClipLabModel(new ClipTopics(own), events, onFailure);
    }

    @Override
    public void keep(ClipLabModel model, Map<String, Kept<?>> kept) {
        kept.put("clip", model);
    }

    @Override
    public void close(ClipLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(ClipLabModel model, Surroundings around) {
        return new ClipPanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<ClipLabModel>> cards() {
        return Stream.of(ClipMode.values()).map(this::card).toList();
    }

    private TopicCard<ClipLabModel> card(ClipMode mode) {
        return new TopicCard<>(
                mode.topic(),
                this,
                ClipColors.OWN,
                TopicBinding.<ClipLabModel>inTurn(
                                ClipLabModel::history,
                                (lab, input) -> lab.showInput(mode, input),
                                ClipLabModel::chooseMethod)
                        .writing(
                                mode.topic(),
                                lab -> Optional.of(ClipCommand.of(lab.state().choice().scene())))
                        .withOwn(
                                ClipLabModel::history,
                                lab -> lab.chooseMode(mode),
                                ClipLabModel::chooseMethod,
                                ClipLabModel::compareWith));
    }

    @Override
    public List<LabShot<ClipLabModel>> shots() {
        return List.of(LabShot.first("clip"));
    }
}
