package rasterlab.app.coordinates.stack;

import java.util.function.Consumer;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.coordinates.figure.LabCard;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The lab of stacks as the tab shows it, in one language. */
public final class StackPanel extends LabCard {
    private static final long serialVersionUID = 1L;

    private final transient StackLabModel model;
    private final transient Texts texts;
    private final StackStage stage;
    private final transient StackInspector inspector;

    /**
     * @param onMode told when another lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public StackPanel(
            StackLabModel model,
            Language language,
            Consumer<CoordinatesMode> onMode,
            Consumer<Throwable> onFailure) {
        super("stack", model, language);
        texts = Texts.of("coordinates.stack", language);
        this.model = model;
        stage = new StackStage(model, texts, onFailure);
        inspector =
                new StackInspector(model, texts, modes(CoordinatesMode.STACK, language, onMode));
        addCopies(
                stage::shown,
                () -> stage.shown().svg(),
                () -> CubeCommand.of(model.scene()),
                onFailure);
        play(programs(), stage, inspector.column(), model, texts);
    }

    private Chips programs() {
        var chips = new Chips(texts, "programs");
        for (StackProgram each : StackProgram.values())
            chips.add(
                    each.code(),
                    texts.text("program." + each.code()),
                    texts.text("program." + each.code() + ".hint"),
                    () -> model.show(each));
        return chips;
    }

    @Override
    protected String unjudged() {
        return texts.text("unjudged");
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
        boolean drawn = !model.scene().cubes().isEmpty();
        actions().enable("copyCommand", drawn);
        actions().hint("copyCommand", texts.text(drawn ? "copy.cube" : "copy.none"));
    }

    @Override
    protected void closeStage() {
        stage.close();
    }
}
