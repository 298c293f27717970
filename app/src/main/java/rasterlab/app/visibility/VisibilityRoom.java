package rasterlab.app.visibility;

import java.util.List;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import rasterlab.app.canvas.Kept;
import rasterlab.app.canvas.LabPanel;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.card.LabRoom;
import rasterlab.app.card.LabShot;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicCard.Place;
import rasterlab.app.card.TopicInput;
import rasterlab.app.card.TopicWay;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowColours;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.hidden.SurfaceView;
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
        return List.of(
                card(
                        "hidden-surfaces",
                        "",
                        (in, method) -> TopicView.of(in.name(), (SurfaceView) in.input(), method)),
                card(
                        "visible-faces",
                        "faces.",
                        (in, method) ->
                                TopicView.of(
                                        in.name(), (Body) in.input(), method, drawnBy(method))),
                card(
                        "depth-order",
                        "order.",
                        (in, method) ->
                                TopicView.of(
                                        in.name(), (Sight) in.input(), method, drawnBy(method))),
                row("depth-buffer"),
                row("depth-triangle"));
    }

    private TopicCard<VisibilityLabModel> row(String topic) {
        return new TopicCard<>(
                topic,
                this,
                new Place("row", ""),
                RowColours.OWN,
                TopicWay.<VisibilityLabModel>whole(
                                (lab, input, method) -> {
                                    if (input.hazard().isEmpty())
                                        lab.rows().show(topic, input.input(), method);
                                    else lab.rows().show(topic, input.hazard(), method);
                                })
                        .withOwn(
                                lab -> lab.rows().history(),
                                lab -> lab.rows().openAgain(topic),
                                (lab, method) -> lab.rows().chooseMethod(method),
                                (lab, method) -> {}));
    }

    private static String drawnBy(String method) {
        return DRAWN_BY.getOrDefault(method, method);
    }

    private TopicCard<VisibilityLabModel> card(
            String topic, String part, BiFunction<TopicInput, String, TopicView> view) {
        return new TopicCard<>(
                topic,
                this,
                new Place("visibility", part),
                VisibilityColours.OWN,
                TopicWay.noted(
                        (lab, input, method) -> {
                            lab.rows().close();
                            lab.choose(view.apply(input, method)::shown);
                        },
                        new TopicWay.Notes<>(
                                (lab, input, method) -> view.apply(input, method).unlike(),
                                method -> true,
                                VisibilityLabModel::tell)));
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
        lab.compareColours("cyclic-overlap", "painter", "newell");
        lab.watchSteps(true);
    }
}
