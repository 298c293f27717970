package rasterlab.app.polygon;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rasterlab.app.canvas.file.Kept;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicBinding;
import rasterlab.app.card.TopicCard;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.outcome.PolygonTopics;

/** The lab of polygons: what is inside, triangulation, filling. */
public final class PolygonRoom implements LabRoom<PolygonLabModel> {
    @Override
    public String name() {
        return "polygon";
    }

    @Override
    public PolygonLabModel model(Executor events, Consumer<Throwable> onFailure, OwnMethods own) {
        return new PolygonLabModel(new PolygonTopics(own), events, onFailure);
    }

    @Override
    public void keep(PolygonLabModel model, Map<String, Kept<?>> kept) {
        kept.put("polygon", model);
    }

    @Override
    public void close(PolygonLabModel model) {
        model.close();
    }

    @Override
    public LabPanel panel(PolygonLabModel model, Surroundings around) {
        return new PolygonPanel(model, around.language(), around.onFailure());
    }

    @Override
    public List<TopicCard<PolygonLabModel>> cards() {
        return Stream.of(PolygonMode.values()).map(this::card).toList();
    }

    private TopicCard<PolygonLabModel> card(PolygonMode mode) {
        return new TopicCard<>(
                mode.topic(),
                this,
                PolygonColors.OWN,
                TopicBinding.<PolygonLabModel>inTurn(
                                PolygonLabModel::history,
                                (lab, input) -> lab.showInput(mode, input),
                                PolygonLabModel::chooseMethod)
                        .writing(
                                mode.topic(),
                                lab -> PolygonCommand.of(lab.state().choice().scene()))
                        .withOwn(
                                PolygonLabModel::history,
                                lab -> lab.chooseMode(mode),
                                PolygonLabModel::chooseMethod,
                                PolygonLabModel::compareWith));
    }

    @Override
    public List<LabShot<PolygonLabModel>> shots() {
        return List.of(
                new LabShot<>("polygon", PolygonRoom::showOverflow),
                new LabShot<>("seed", lab -> lab.chooseMode(PolygonMode.SEED)));
    }

    /** Shows the plane as it looks to a method in 32 bits, far from the origin. */
    private static void showOverflow(PolygonLabModel lab) {
        lab.show(PolygonMode.TRIANGLE, "past-2-15");
        lab.chooseMethod("sign-int");
    }
}
