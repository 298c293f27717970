package rasterlab.app.coordinates.stack;

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

/** The lab of stacks as the tab shows it, in one language. */
public final class StackPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient StackLabModel model;
    private final transient Texts texts;
    private final StackStage stage;
    private final transient StackInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final transient Runnable unsubscribe;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public StackPanel(
            StackLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        this.model = model;
        setName("stack");
        texts = Texts.of("coordinates.stack", language);
        Texts canvas = Texts.of("canvas", language);
        stage = new StackStage(model, texts, onFailure);
        inspector =
                new StackInspector(
                        model,
                        texts,
                        column -> modeRow(column, CoordinatesMode.STACK, language, onMode));
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
                () ->
                        CubeCommand.of(model.scene())
                                .ifPresent(command -> Copying.text(command, onFailure)));
        add(new LabLayout(chips(), stage, inspector.column(), actions, player));
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(choice -> refresh());
        refresh();
    }

    private Chips chips() {
        var chips = new Chips(texts.text("programs"));
        for (StackProgram each : StackProgram.values())
            chips.add(
                    each.code(),
                    texts.text("program." + each.code()),
                    texts.text("program." + each.code() + ".hint"),
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
        boolean drawn = !model.scene().cubes().isEmpty();
        actions.enable("copyCommand", drawn);
        actions.hint("copyCommand", texts.text(drawn ? "copy.cube" : "copy.none"));
    }
}
