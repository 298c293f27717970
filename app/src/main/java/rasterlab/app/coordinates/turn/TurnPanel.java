package rasterlab.app.coordinates.turn;

import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.KeyStroke;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.card.TopicChips;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** The lab of rotations as the tab shows it, in one language. */
public final class TurnPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient TurnLabModel model;
    private final transient Texts texts;
    private final TurnStage stage;
    private final transient TurnInspector inspector;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public TurnPanel(
            TurnLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        super("rotation", model, language);
        this.model = model;
        texts = Texts.of("coordinates.turn", language);
        stage = new TurnStage(model, texts, onFailure);
        inspector =
                new TurnInspector(model, texts, modes(CoordinatesMode.ROTATION, language, onMode));
        addCopies(() -> stage, stage::svg, () -> Optional.of(model.command()), onFailure);
        actions().addQuestions(() -> "rotate");
        play(
                TopicChips.of(
                        texts,
                        "rotate",
                        model.hazards(),
                        model.methods().stream().map(Method::name).toList(),
                        model::show),
                stage,
                inspector.column(),
                model,
                texts);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), model::cancel);
        model.begin();
    }

    @Override
    protected LabInput input() {
        return new LabInput(
                () -> model.choice().withMethod(""),
                () -> model.choice().method(),
                model::chooseMethod,
                FigureColors.OWN);
    }

    @Override
    protected String first() {
        return texts.text("first");
    }

    @Override
    public void focusPicture() {
        stage.focusPoint();
    }

    @Override
    protected void refreshParts() {
        stage.refresh();
        inspector.refresh();
    }

    @Override
    protected void closeStage() {
        stage.close();
    }
}
