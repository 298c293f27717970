package rasterlab.app.row;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.HazardCase;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** The lab of rows as its tab shows it, in one language. */
public final class RowPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient RowLabModel model;
    private final transient Texts texts;
    private final RowStage stage;
    private final transient RowInspector inspector;

    /**
     * @param tab whose texts name its labs
     * @param modes names of the tab's labs, the topics of this one among them
     * @param onMode told which of them is chosen
     * @param onFailure told what a control could not do
     */
    public RowPanel(
            RowLabModel model,
            Texts tab,
            List<String> modes,
            Consumer<String> onMode,
            Consumer<Throwable> onFailure) {
        super("rows", model, tab.language());
        Language language = tab.language();
        texts = Texts.of("row", language);
        this.model = model;
        stage = new RowStage(model, texts);
        inspector = new RowInspector(model, texts, tab, modes, onMode);
        addCopies(() -> stage, stage::svg, () -> Optional.of(model.command()), onFailure);
        actions().addQuestions(() -> model.choice().topic());
        var steps =
                new StepPlayer(
                        Texts.of("canvas", language),
                        model.steps(),
                        () -> model.choice().pixel() + " / " + (model.pixels() - 1));
        play(chips(texts, language), stage, inspector.column(), steps);
        prepare();
    }

    /** Finds the verdicts of the other hazards before they are chosen. */
    private void prepare() {
        var thread = new Thread(model::prepare, "rows");
        thread.setDaemon(true);
        thread.start();
    }

    private Chips chips(Texts texts, Language language) {
        var chips = new Chips(texts, "hazards");
        model.hazards().map(each -> each.topic()).distinct().forEach(chips::of);
        model.hazards()
                .forEach(
                        each -> {
                            TopicTexts said = TopicTexts.of(each.topic(), language);
                            chips.add(
                                    HazardCase.of(
                                            each.hazard(),
                                            said.title(each.hazard()),
                                            said.hazard(each.hazard()),
                                            model.methods(each.topic()).stream()
                                                    .map(Method::name)
                                                    .toList(),
                                            () ->
                                                    model.show(
                                                            each.topic(),
                                                            each.hazard().name(),
                                                            "")));
                        });
        return chips;
    }

    @Override
    protected void whenDrawn(Runnable taken) {
        model.whenShown(taken);
    }

    @Override
    protected LabInput input() {
        return new LabInput(
                () -> List.of(model.choice().topic(), model.choice().hazard()),
                () -> model.choice().method(),
                model::chooseMethod,
                RowColors.OWN);
    }

    @Override
    protected String first() {
        return texts.text("first");
    }

    @Override
    public void focusPicture() {
        stage.requestFocusInWindow();
    }

    @Override
    protected void refreshParts() {
        stage.repaint();
        inspector.refresh();
        actions().enable(Actions.QUESTIONS, model.asksSteps());
    }

    @Override
    protected void closeStage() {}
}
