package rasterlab.app.coordinates.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.HazardCase;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.FigureColors;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The lab of views as the tab shows it, in one language. */
public final class ViewPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient ViewLabModel model;
    private final transient Texts texts;
    private final transient ViewInspector inspector;
    private final transient Consumer<Throwable> onFailure;
    private ViewStageView stage;
    private Chips situations;
    private StepPlayer stages;
    private transient Runnable endOfStage = () -> {};

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public ViewPanel(
            ViewLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        super("views", model, language);
        this.model = model;
        this.onFailure = onFailure;
        texts = Texts.of("coordinates.view", language);
        inspector = new ViewInspector(model, texts, modes(CoordinatesMode.VIEWS, language, onMode));
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<Runnable>();
        parts.add(this::addStage);
        parts.addAll(inspector.sections());
        parts.add(this::addRows);
        parts.add(this::putTogether);
        // A part that has been shown once is quick to show again.
        parts.add(inspector::showChoice);
        parts.add(inspector::showNumbers);
        return parts;
    }

    private void addStage() {
        stage = new ViewStageView(model, texts, onFailure);
        endOfStage = stage::close;
    }

    private void addRows() {
        addCopies(
                stage::shown,
                () -> stage.shown().svg(),
                () -> Optional.of(ViewCommand.of(model.scene(), model.step())),
                onFailure);
        actions().addQuestions(() -> "view");
        situations = situations(model, texts);
        stages =
                new StepPlayer(
                        Texts.of("canvas", texts.language()),
                        model,
                        () -> called(model.stage().space()));
        for (ViewStage.CoordinateSpace each : ViewStage.CoordinateSpace.values())
            stages.reserve(called(each));
    }

    private String called(ViewStage.CoordinateSpace space) {
        return texts.text("space." + space.code() + ".short");
    }

    private void putTogether() {
        play(situations, stage, inspector.column(), stages);
    }

    private static Chips situations(ViewLabModel model, Texts texts) {
        var chips = new Chips(texts, "situations");
        for (ViewSituation each : ViewSituation.values())
            chips.add(
                    HazardCase.unjudged(
                                    each.code(),
                                    texts.text("situation." + each.code()),
                                    texts.text("situation." + each.code() + ".hint"),
                                    () -> model.show(each))
                            .judged(model.verdicts(each)));
        return chips;
    }

    /** The view that every method is given. */
    @Override
    protected LabInput input() {
        String any = model.methods().get(0).name();
        return new LabInput(
                () -> model.choice().withMethod(any),
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
        endOfStage.run();
    }
}
