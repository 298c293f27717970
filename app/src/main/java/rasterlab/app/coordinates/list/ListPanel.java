package rasterlab.app.coordinates.list;

import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.StepPlayer;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The lab of lists as the tab shows it, in one language. */
public final class ListPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final ListStage stage;
    private final transient ListInspector inspector;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public ListPanel(
            ListLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        super("transformations", model, language);
        Texts texts = Texts.of("coordinates.list", language);
        stage = new ListStage(model, texts, onFailure);
        inspector =
                new ListInspector(
                        model,
                        texts,
                        column ->
                                modeRow(column, CoordinatesMode.TRANSFORMATIONS, language, onMode));
        addCopies(
                stage::shown,
                () -> stage.shown().svg(),
                () -> Optional.of(ListCommand.of(model.scene(), model.step())),
                onFailure);
        play(
                hazards(
                        texts,
                        Texts.of("coordinates.list", "topic", language),
                        model.hazards(),
                        model::show),
                stage,
                inspector.column(),
                new StepPlayer(
                        Texts.of("canvas", language),
                        model,
                        () -> texts.text("count", model.step(), model.last())));
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
