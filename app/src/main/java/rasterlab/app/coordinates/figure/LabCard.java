package rasterlab.app.coordinates.figure;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JComponent;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.canvas.player.Steps;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * One of the tab's labs, in one language: chips above, stage, inspector, the buttons that all labs
 * have, and a row below the stage.
 */
public abstract class LabCard extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient ChoiceModel<?> model;
    private final Actions actions;
    private transient Optional<StepPlayer> player = Optional.empty();
    private StageGuide guide;
    private transient Runnable unsubscribe = () -> {};

    protected LabCard(String name, ChoiceModel<?> model, Language language) {
        this.model = model;
        setName(name);
        actions = new Actions(Texts.of("canvas", language));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
    }

    /**
     * Adds the buttons that save and copy what is shown.
     *
     * @param command empty where no command draws it
     * @param onFailure told what could not be copied or saved
     */
    protected final void addCopies(
            Supplier<? extends JComponent> picture,
            Supplier<SvgDrawing> svg,
            Supplier<Optional<String>> command,
            Consumer<Throwable> onFailure) {
        actions.addPicture(
                new ShownPicture(
                        getName(), () -> ShownPicture.dotsOf(picture.get()), svg, this::whenDrawn),
                onFailure);
        actions.addCopy("copyCommand", told -> command.get().ifPresent(told));
    }

    /** Runs it as soon as the picture is that of the present choice. */
    protected void whenDrawn(Runnable taken) {
        taken.run();
    }

    protected final Actions actions() {
        return actions;
    }

    /** Puts the parts of a lab with steps together and shows the model from now on. */
    protected final void play(
            JComponent chips, JComponent stage, Inspector inspector, StepPlayer steps) {
        player = Optional.of(steps);
        steps.bindKeys(stage);
        arrange(chips, stage, inspector, steps);
    }

    /** Puts the parts of a lab together whose steps are counted, as its texts say. */
    protected final void play(
            JComponent chips, JComponent stage, Inspector inspector, Steps steps, Texts texts) {
        var counted =
                new StepPlayer(
                        Texts.of("canvas", texts.language()),
                        steps,
                        () -> texts.text("count", steps.step(), steps.last()));
        play(chips, stage, inspector, counted);
    }

    /** Puts the parts together and shows the model from now on. */
    protected final void arrange(
            JComponent chips, JComponent stage, Inspector inspector, JComponent below) {
        var layout = new LabLayout(chips, stage, inspector, actions, below);
        guide = layout.guide().of(input());
        add(layout);
        Actions.bindUndo(this, model.history());
        unsubscribe = model.listen(choice -> refresh());
    }

    @Override
    public final void refresh() {
        refreshParts();
        player.ifPresent(StepPlayer::refresh);
        actions.refreshUndo();
        guide.refresh();
        guide.hint("coordinates." + getName(), first());
    }

    /**
     * Describes the input that hazards are compared with; a card that judges methods overrides it.
     */
    protected LabInput input() {
        return LabInput.unjudged(model::choice, unjudged());
    }

    /** A sentence that says why no method is judged; "" in a card that judges them. */
    protected String unjudged() {
        return "";
    }

    /** A sentence that says what to do on the stage. */
    protected abstract String first();

    /** Shows the model's present state on stage and inspector. */
    protected abstract void refreshParts();

    /** Ends the threads that paint. */
    protected abstract void closeStage();

    @Override
    public final void stop() {
        player.ifPresent(StepPlayer::stop);
    }

    @Override
    public final void close() {
        stop();
        unsubscribe.run();
        closeStage();
    }

    /** Adds a row that leads to the other labs; in this one it always shows this one's name. */
    protected static Consumer<Inspector> modes(
            CoordinatesMode own, Language language, Consumer<CoordinatesMode> chosen) {
        return column -> column.row("mode", chooser(own, language, chosen));
    }

    private static NameChooser chooser(
            CoordinatesMode own, Language language, Consumer<CoordinatesMode> chosen) {
        Texts texts = Texts.of("coordinates", language);
        var chooser = new NameChooser[1];
        chooser[0] =
                new NameChooser(
                        "mode",
                        Stream.of(CoordinatesMode.values()).map(CoordinatesMode::code).toList(),
                        code -> texts.text("mode." + code),
                        code -> {
                            chooser[0].show(own.code());
                            chosen.accept(CoordinatesMode.named(code));
                        });
        chooser[0].show(own.code());
        return chooser[0];
    }
}
