package rasterlab.app.line;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.card.TopicChips;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineColors;
import rasterlab.engine.study.Method;

/** The lab of segments as the window shows it, in one language. */
final class SegmentPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient LineLabModel model;
    private final transient Texts texts;
    private final LineStage stage;
    private final transient LineInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private StageGuide guide;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    SegmentPanel(LineLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        texts = Texts.of("line", language);
        stage = new LineStage(model, texts, onFailure);
        inspector = new LineInspector(model, texts);
        player =
                new StepPlayer(
                        Texts.of("canvas", language),
                        model,
                        () -> texts.text("count", model.step(), model.last()));
        actions = new Actions(Texts.of("canvas", language));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(new ShownPicture("segment", stage, stage::svg), onFailure);
        actions.addCopy("copyCommand", told -> told.accept(LineCommand.of(model.state().choice())));
        actions.addQuestions(() -> "line");
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<>(inspector.sections());
        parts.add(this::putTogether);
        return parts;
    }

    private void putTogether() {
        var layout = new LabLayout(chips(), stage, inspector.column(), actions, player);
        guide =
                layout.guide()
                        .of(
                                new LabInput(
                                        () -> model.state().choice().segment(),
                                        () -> model.state().choice().method(),
                                        model::chooseMethod,
                                        LineColors.OWN));
        add(layout);
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(state -> refresh());
    }

    /** Gives the keyboard to the end of the segment that had it last. */
    @Override
    public void focusPicture() {
        stage.focusEnd();
    }

    /** Stops listening and playing; the model lives on. */
    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
        stage.close();
    }

    @Override
    public void stop() {
        player.stop();
    }

    @Override
    public void refresh() {
        stage.refresh();
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
        guide.refresh();
        guide.hint("line.segment", texts.text("first.segment"));
    }

    private Chips chips() {
        return TopicChips.of(
                texts,
                "line",
                model.hazards(),
                model.methods().stream().map(Method::name).toList(),
                hazard -> model.show(hazard.input()));
    }
}
