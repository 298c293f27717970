package rasterlab.app.coordinates.view;

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

/** The lab of views as the tab shows it, in one language. */
public final class ViewPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient ViewLabModel model;
    private final ViewStageView stage;
    private final transient ViewInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final transient Runnable unsubscribe;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public ViewPanel(
            ViewLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        this.model = model;
        setName("views");
        Texts texts = Texts.of("coordinates.view", language);
        Texts canvas = Texts.of("canvas", language);
        stage = new ViewStageView(model, texts, onFailure);
        inspector =
                new ViewInspector(
                        model,
                        texts,
                        column -> modeRow(column, CoordinatesMode.VIEWS, language, onMode));
        player =
                new StepPlayer(
                        canvas,
                        model,
                        () -> texts.text("space." + model.stage().space().code() + ".short"));
        actions = new Actions(canvas);
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.add("copyPicture", () -> Copying.picture(stage.shown(), onFailure));
        actions.add("copySvg", () -> Copying.svg(stage.shown().svg(), onFailure));
        actions.add(
                "copyCommand",
                () -> Copying.text(ViewCommand.of(model.scene(), model.step()), onFailure));
        add(new LabLayout(chips(texts), stage, inspector.column(), actions, player));
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(choice -> refresh());
        refresh();
    }

    private Chips chips(Texts texts) {
        var chips = new Chips(texts.text("situations"));
        for (ViewSituation each : ViewSituation.values())
            chips.add(
                    each.code(),
                    texts.text("situation." + each.code()),
                    texts.text("situation." + each.code() + ".hint"),
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
