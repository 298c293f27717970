package rasterlab.app.line;

import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.ModeRows;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.card.TopicChips;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.FigureCommand;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.figure.FigureStage;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.LineMode;

/** Circles, ellipses, lines of a pen and the chart of brightness, in one language. */
final class FigurePanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient FigureLabModel model;
    private final transient Texts texts;
    private final FigureStage stage;
    private final transient FigureInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final ModeRows<LineMode> above = new ModeRows<>(this::above);
    private final StageGuide guide;
    private final transient Runnable unsubscribe;

    /**
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    FigurePanel(LineLabModel lab, Language language, Consumer<Throwable> onFailure) {
        model = lab.figures();
        texts = Texts.of("line", language);
        stage = new FigureStage(model, texts, onFailure);
        inspector = new FigureInspector(lab, texts);
        player =
                new StepPlayer(
                        Texts.of("canvas", language),
                        model,
                        () -> texts.text("count", model.step(), model.last()));
        actions = new Actions(Texts.of("canvas", language));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(new ShownPicture("figure", stage, stage::svg), onFailure);
        actions.addCopy("copyCommand", told -> command().ifPresent(told));
        actions.addQuestions(() -> model.state().scene().mode().code());
        var layout = new LabLayout(above, stage, inspector.column(), actions, player);
        guide =
                layout.guide()
                        .of(
                                new LabInput(
                                        () -> model.state().scene().figure(),
                                        () -> model.state().scene().method(),
                                        model::chooseMethod,
                                        LineColors.OWN));
        add(layout);
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(state -> refresh());
    }

    private Optional<String> command() {
        return FigureCommand.of(model.state().scene());
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        stage.focusPoint();
    }

    @Override
    public void stop() {
        player.stop();
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
        above.show(model.state().scene().mode());
        stage.refresh();
        inspector.refresh();
        player.refresh();
        player.setVisible(hasSteps(model.state().scene().mode()));
        actions.refreshUndo();
        guide.refresh();
        String mode = model.state().scene().mode().code();
        guide.hint("line." + mode, texts.text("first." + mode));
        actions.enable("copyCommand", command().isPresent());
        actions.enable(Actions.QUESTIONS, hasSteps(model.state().scene().mode()));
    }

    /** Whether methods draw it pixel by pixel. */
    private static boolean hasSteps(LineMode mode) {
        return mode == LineMode.CIRCLE || mode == LineMode.ELLIPSE;
    }

    private JComponent above(LineMode mode) {
        if (hasSteps(mode)) return chips(mode);
        var sentence = new WrappedText("introduction");
        sentence.show(texts.text("figure.intro." + mode.code()));
        return sentence;
    }

    private Chips chips(LineMode mode) {
        return TopicChips.of(
                texts,
                mode.code(),
                model.hazards(mode),
                model.methods(mode),
                hazard -> model.show(mode, hazard.name()));
    }
}
