package rasterlab.app.clip;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.ModeRows;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.card.TopicChips;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.signmap.SignMaps;
import rasterlab.app.signmap.SignWindow;

/** The clipping lab as the window shows it, in one language. */
public final class ClipPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient ClipLabModel model;
    private final transient Texts texts;
    private final ClipStage stage;
    private final transient ClipInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final ModeRows<ClipMode> chips = new ModeRows<>(this::chips);
    private StageGuide guide;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public ClipPanel(ClipLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setName("clip");
        texts = Texts.of("clip", language);
        inspector = new ClipInspector(model, texts);
        stage = new ClipStage(model, texts, onFailure);
        player = new StepPlayer(Texts.of("canvas", language), model, this::count);
        player.reserve(texts.text("count.result"));
        actions = new Actions(Texts.of("canvas", language));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(new ShownPicture("clipping", stage, stage::svg), onFailure);
        actions.addCopy(
                "copyCommand", told -> told.accept(ClipCommand.of(model.state().choice().scene())));
        actions.add(
                "signMaps",
                () ->
                        SignWindow.open(
                                this, model.state().choice().mode().topic(), language, onFailure));
        actions.addQuestions(() -> model.state().choice().mode().topic());
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<>(inspector.sections());
        parts.add(this::putTogether);
        return parts;
    }

    private void putTogether() {
        var layout = new LabLayout(chips, stage, inspector.column(), actions, player);
        guide =
                layout.guide()
                        .of(
                                new LabInput(
                                        () ->
                                                model.state()
                                                        .choice()
                                                        .scene()
                                                        .withMethod("")
                                                        .withComparison(""),
                                        () -> model.state().choice().scene().method(),
                                        model::chooseMethod,
                                        ClipColors.OWN));
        add(layout);
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(state -> refresh());
    }

    private String count() {
        return model.step() == model.last()
                ? texts.text("count.result")
                : texts.text("count", model.step(), model.last() - 1);
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        stage.focusPoint();
    }

    /** Stops listening and playing; the model lives on. */
    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
        stage.close();
    }

    @Override
    public void refresh() {
        chips.show(model.state().choice().mode());
        stage.refresh();
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
        actions.enable(
                "signMaps", SignMaps.ofTopic(model.state().choice().mode().topic()).isPresent());
        guide.refresh();
        String mode = model.state().choice().mode().code();
        guide.hint("clip." + mode, texts.text("first." + mode));
    }

    private Chips chips(ClipMode mode) {
        return TopicChips.of(
                texts,
                mode.topic(),
                model.hazards(mode),
                model.methods(mode),
                hazard -> model.show(mode, hazard.name()));
    }
}
