package rasterlab.app.coordinates.turn;

import java.util.function.Consumer;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.Actions;
import rasterlab.app.canvas.Chips;
import rasterlab.app.canvas.Copying;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.LabLayout;
import rasterlab.app.canvas.StepPlayer;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.transform.rotate.Turns;

/** The lab of rotations as the tab shows it, in one language. */
public final class TurnPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient TurnLabModel model;
    private final TurnStage stage;
    private final transient TurnInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final transient Runnable unsubscribe;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public TurnPanel(
            TurnLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        this.model = model;
        setName("rotation");
        Texts texts = Texts.of("coordinates.turn", language);
        Texts canvas = Texts.of("canvas", language);
        stage = new TurnStage(model, texts, onFailure);
        inspector =
                new TurnInspector(
                        model,
                        texts,
                        column -> modeRow(column, CoordinatesMode.ROTATION, language, onMode));
        player =
                new StepPlayer(
                        canvas, model, () -> texts.text("count", model.step(), model.last()));
        actions = new Actions(canvas);
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.add("copyPicture", () -> Copying.picture(stage, onFailure));
        actions.add("copySvg", () -> Copying.svg(stage.svg(), onFailure));
        actions.add("copyCommand", () -> Copying.text(TurnCommand.of(model.choice()), onFailure));
        add(new LabLayout(chips(texts), stage, inspector.column(), actions, player));
        Actions.bindUndo(this, model.history());
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), model::cancel);
        player.bindKeys(stage);
        unsubscribe = model.listen(choice -> refresh());
        refresh();
        model.begin();
    }

    private Chips chips(Texts texts) {
        Texts translations = Texts.of("coordinates.turn", "topic", texts.language());
        var chips = new Chips(texts.text("hazards"));
        for (Hazard<Turns> each : model.hazards())
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
