package rasterlab.app.coordinates.meeting;

import java.util.function.Consumer;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.card.TopicChips;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** The lab of a line that meets a plane as the tab shows it, in one language. */
public final class MeetingPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient MeetingLabModel model;
    private final transient Texts texts;
    private final MeetingStage stage;
    private final transient MeetingInspector inspector;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public MeetingPanel(
            MeetingLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        super("meeting", model, language);
        this.model = model;
        texts = Texts.of("coordinates.meeting", language);
        stage = new MeetingStage(model, texts, onFailure);
        inspector =
                new MeetingInspector(
                        model, texts, modes(CoordinatesMode.MEETING, language, onMode));
        addCopies(stage::shown, () -> stage.shown().svg(), model::command, onFailure);
        var legend = new WrappedText("legend");
        legend.show(texts.text("legend"));
        arrange(
                TopicChips.of(
                        texts,
                        "line-plane",
                        model.hazards(),
                        model.methods().stream().map(Method::name).toList(),
                        hazard -> model.show(hazard.input())),
                stage,
                inspector.column(),
                legend);
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
        actions().enable("copyCommand", model.command().isPresent());
    }

    @Override
    protected void closeStage() {
        stage.close();
    }
}
