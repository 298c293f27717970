package rasterlab.app.coordinates.list;

import java.util.function.Consumer;
import rasterlab.app.canvas.Actions;
import rasterlab.app.canvas.Chips;
import rasterlab.app.canvas.Copying;
import rasterlab.app.canvas.LabLayout;
import rasterlab.app.canvas.StepPlayer;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.transform.matrix.MatrixCall;

/** The lab of lists as the tab shows it, in one language. */
public final class ListPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient ListLabModel model;
    private final ListStage stage;
    private final transient ListInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final transient Runnable unsubscribe;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public ListPanel(
            ListLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        this.model = model;
        setName("transformations");
        Texts texts = Texts.of("coordinates.list", language);
        Texts canvas = Texts.of("canvas", language);
        stage = new ListStage(model, texts, onFailure);
        inspector =
                new ListInspector(
                        model,
                        texts,
                        column ->
                                modeRow(column, CoordinatesMode.TRANSFORMATIONS, language, onMode));
        player =
                new StepPlayer(
                        canvas, model, () -> texts.text("count", model.step(), model.last()));
        actions = new Actions(canvas);
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.add("copyPicture", () -> Copying.picture(stage.shown(), onFailure));
        actions.add("copySvg", () -> Copying.svg(stage.shown().svg(), onFailure));
        actions.add(
                "copyCommand",
                () -> Copying.text(ListCommand.of(model.scene(), model.step()), onFailure));
        add(new LabLayout(chips(texts), stage, inspector.column(), actions, player));
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(choice -> refresh());
        refresh();
    }

    private Chips chips(Texts texts) {
        Texts translations = Texts.of("coordinates.list", "topic", texts.language());
        var chips = new Chips(texts.text("hazards"));
        for (Hazard<MatrixCall> each : model.hazards())
            chips.add(
                    each.name(),
                    texts.textOr("hazard." + each.name(), each.name()),
                    translations.textOr("hazard." + each.name(), each.description()),
                    () -> model.show(each));
        return chips;
    }

    @Override
    public void focusPicture() {
        stage.focusPoint();
    }

    @Override
    public void stop() {
        player.stop();
    }

    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
        stage.close();
    }

    private void refresh() {
        stage.refresh();
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
    }
}
