package rasterlab.app.visibility;

import java.util.function.Consumer;
import rasterlab.app.canvas.Actions;
import rasterlab.app.canvas.Chips;
import rasterlab.app.canvas.Copying;
import rasterlab.app.canvas.LabLayout;
import rasterlab.app.canvas.LabPanel;
import rasterlab.app.canvas.StepPlayer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The hidden-surface lab as the window shows it, in one language. */
public final class VisibilityPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;
    private final VisibilityStage stage;
    private final transient VisibilityInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final transient Runnable unsubscribe;

    /**
     * @param onFailure told what a control could not do
     */
    public VisibilityPanel(
            VisibilityLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setName("visibility");
        texts = Texts.of("visibility", language);
        stage = new VisibilityStage(model, texts);
        inspector = new VisibilityInspector(model, texts);
        player =
                new StepPlayer(
                        Texts.of("canvas", language),
                        new DrawingSteps(model),
                        () -> new VisibilityReadings(model.state(), texts).timeline());
        actions = new Actions(Texts.of("canvas", language));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.add("copyPicture", () -> Copying.picture(stage, onFailure));
        actions.add("copySvg", () -> Copying.svg(stage.svg(), onFailure));
        actions.add("copyCommand", () -> Copying.text(VisibilityCommand.of(model), onFailure));
        add(new LabLayout(chips(), stage, inspector.column(), actions, player));
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        SceneRow.acceptFiles(stage, model, onFailure);
        Runnable noModel = model.listen(state -> refresh());
        Runnable noCharts = model.charts().listen(stage::refresh);
        unsubscribe =
                () -> {
                    noModel.run();
                    noCharts.run();
                };
        refresh();
    }

    /** Gives the keyboard to the picture, whose arrow keys turn the scene. */
    @Override
    public void focusPicture() {
        stage.requestFocusInWindow();
    }

    /** Stops listening and playing; the model lives on. */
    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
    }

    private void refresh() {
        stage.refresh();
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
    }

    private Chips chips() {
        var chips = new Chips(texts, "hazards");
        for (HazardView view : HazardView.values())
            chips.add(
                    view.code(),
                    texts.text("hazard." + view.code()),
                    texts.text("hazard." + view.code() + ".hint"),
                    () -> model.choose(view::shown));
        return chips;
    }
}
