package rasterlab.app.opengl;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/** The OpenGL lab as the window shows it, in one language. */
public final class OpenGlPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient OpenGlLabModel model;
    private final transient Texts texts;
    private final OpenGlStage stage;
    private final transient OpenGlInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private StageGuide guide;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do
     */
    public OpenGlPanel(OpenGlLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setName("opengl");
        texts = Texts.of("opengl", language);
        inspector = new OpenGlInspector(model, texts);
        stage = new OpenGlStage(model, texts, model::open);
        player = new StepPlayer(Texts.of("canvas", language), new GlTurntable(model), this::angle);
        player.reserve(texts.text("turntable", "359"));
        actions = new Actions(Texts.of("canvas", language));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(new ShownPicture("opengl", stage, stage::svg), onFailure);
        actions.addCopy("copyCommand", told -> command().ifPresent(told));
        actions.addCopy("copyCalls", told -> told.accept(stage.log().program()));
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
                        .dock()
                        .of(
                                LabInput.unjudged(
                                        () -> model.state().choice(), texts.text("unjudged")));
        add(layout);
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage.picture());
        unsubscribe = model.listen(state -> refresh());
    }

    /** The command of the software picture; empty before there is one. */
    private Optional<String> command() {
        OpenGlLabState state = model.state();
        return state.pictures()
                .software()
                .map(drawn -> SoftwareHalf.command(state.choice(), drawn.width(), drawn.height()));
    }

    private String angle() {
        return texts.text(
                "turntable", Shown.number(model.state().choice().turn(), 1, texts.locale()));
    }

    /** Gives the keyboard to the picture, whose arrow keys turn the scene. */
    @Override
    public void focusPicture() {
        stage.picture().requestFocusInWindow();
    }

    /** Stops listening and playing; the model lives on, OpenGL's window goes with the panel. */
    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
    }

    @Override
    public void refresh() {
        stage.refresh();
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
        guide.refresh();
        guide.hint("opengl", texts.text("first"));
        actions.enable("copyCommand", command().isPresent());
        actions.hint("copyCommand", texts.text("copy.software"));
    }

    private Chips chips() {
        var chips = new Chips(texts, "hazards");
        for (GlView view : GlView.values())
            chips.add(
                    view.code(),
                    texts.text("hazard." + view.code()),
                    texts.text("hazard." + view.code() + ".hint"),
                    () -> model.show(view));
        return chips;
    }
}
