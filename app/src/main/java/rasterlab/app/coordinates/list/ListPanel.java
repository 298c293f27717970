package rasterlab.app.coordinates.list;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.ModeRows;
import rasterlab.app.card.TopicChips;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** The lab of lists as the tab shows it, in one language. */
public final class ListPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient ListLabModel model;
    private final transient Texts texts;
    private final ModeRows<String> chips;
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
        this.model = model;
        texts = Texts.of("coordinates.list", language);
        stage = new ListStage(model, texts, onFailure);
        inspector =
                new ListInspector(
                        model, texts, modes(CoordinatesMode.TRANSFORMATIONS, language, onMode));
        addCopies(
                stage::shown,
                () -> stage.shown().svg(),
                () -> Optional.of(ListCommand.of(model)),
                onFailure);
        actions().addQuestions(() -> model.choice().trial().map(Trial::topic).orElse("transform"));
        chips = new ModeRows<>(topic -> chips(model, topic, texts));
        play(chips, stage, inspector.column(), model, texts);
    }

    private static Chips chips(ListLabModel model, String topic, Texts texts) {
        return topic.equals(TrialRows.MATRICES)
                ? TopicChips.of(
                        texts,
                        "matrix",
                        model.hazards(),
                        model.methods().stream().map(Method::name).toList(),
                        model::show)
                : TopicChips.of(
                        texts,
                        topic,
                        model.trials().hazards(topic),
                        model.trials().methods(topic).stream().map(Method::name).toList(),
                        hazard -> model.show(topic, hazard.name(), ""));
    }

    @Override
    protected LabInput input() {
        return new LabInput(this::asked, this::method, this::choose, FigureColors.OWN);
    }

    private Object asked() {
        ListChoice choice = model.choice();
        return List.of(choice.subject(), choice.items(), choice.trial().map(now -> now.by("")));
    }

    private String method() {
        return model.choice().trial().map(Trial::method).orElseGet(() -> model.choice().method());
    }

    private void choose(String method) {
        model.choice()
                .trial()
                .ifPresentOrElse(
                        now -> model.show(now.by(method)), () -> model.chooseMethod(method));
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
        chips.show(model.choice().trial().map(Trial::topic).orElse(TrialRows.MATRICES));
        stage.refresh();
        inspector.refresh();
    }

    @Override
    protected void closeStage() {
        stage.close();
    }
}
