package rasterlab.app.light.panel;

import java.awt.CardLayout;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JPanel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.file.FileDrop;
import rasterlab.app.canvas.file.SceneWriting;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.HazardCase;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.ColorChoice;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightHazard;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.light.LitBody;
import rasterlab.app.light.step.OwnSteps;
import rasterlab.app.light.step.OwnTimeline;
import rasterlab.app.row.RowCard;
import rasterlab.app.row.RowPanel;
import rasterlab.contract.ColorModel;
import rasterlab.engine.study.Verdict;

/** The lighting lab as the window shows it, in one language: light, colour models, or textures. */
public final class LightPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient LightLabModel model;
    private final transient Texts texts;
    private final transient Consumer<Throwable> onFailure;
    private final transient LightVerdicts verdicts;
    private final CardLayout cards = new CardLayout();
    private final JPanel shown = new JPanel(cards);
    private final LightStage stage;
    private final CubeStage cube;
    private final transient RowCard rows;
    private final transient LightInspector light;
    private final transient ColorInspector colors;
    private final StepPlayer orbit;
    private final StepPlayer turning;
    private final transient LitSceneSaving saving;
    private final Actions lightActions;
    private final Actions colorActions;
    private StageGuide lightGuide;
    private StageGuide colorGuide;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do
     */
    public LightPanel(LightLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        this.onFailure = onFailure;
        verdicts = new LightVerdicts(EventQueue::invokeLater, onFailure);
        setName("light");
        texts = Texts.of("light", language);
        light = new LightInspector(model, texts);
        colors = new ColorInspector(model, texts);
        stage = new LightStage(model, texts);
        cube = new CubeStage(model, texts);
        Texts canvas = Texts.of("canvas", language);
        var timeline = new OwnTimeline(this::ownSteps, model.walk, new LampOrbit(model));
        orbit = new StepPlayer(canvas, timeline, this::orbitReading);
        turning = new StepPlayer(canvas, new CubeTurning(model), this::turningReading);
        orbit.reserve(texts.text("orbit", "−180"));
        turning.reserve("−359°");
        lightActions = actions(canvas, new ShownPicture("lighting", stage, stage::svg));
        colorActions = actions(canvas, new ShownPicture("colours", cube, cube::svg));
        var writing = new SceneWriting(this, language, lightActions::saved, onFailure);
        saving = new LitSceneSaving(model, texts, this, writing);
        lightActions.add("openScene", saving::open);
        lightActions.add("saveScene", saving::ask);
        stage.setTransferHandler(new FileDrop(this, language, model::open));
        lightActions.addCopy("copyCommand", saving::tellCommands);
        lightActions.addQuestions(
                () -> model.state().choice().arrows() ? "vertex-normals" : "shade-face");
        colorActions.addCopy(
                "copyCommand", told -> told.accept(ColorCommand.of(model.state().color())));
        rows = new RowCard(shown, cards, this::rows);
        orbit.bindKeys(stage);
        turning.bindKeys(cube);
        add(shown);
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<>(light.sections());
        parts.add(this::addLight);
        parts.addAll(colors.sections());
        parts.add(this::addColors);
        parts.add(this::listen);
        return parts;
    }

    private void addLight() {
        var layout = new LabLayout(chips(), stage, light.column(), lightActions, orbit);
        lightGuide =
                layout.guide()
                        .dock()
                        .of(
                                new LabInput(
                                        this::lit,
                                        this::normals,
                                        this::chooseNormals,
                                        LightColors.OWN,
                                        name -> texts.text("normals." + name),
                                        texts.text("unjudged")));
        addCard(layout, ModeRow.LIGHT);
    }

    private void addColors() {
        var layout = new LabLayout(colorChips(), cube, colors.column(), colorActions, turning);
        colorGuide =
                layout.guide()
                        .of(
                                new LabInput(
                                        () -> model.state().color().rgb(),
                                        () -> model.state().color().method(),
                                        name -> model.color(color -> color.withMethod(name)),
                                        LightColors.OWN));
        addCard(layout, ModeRow.COLORS);
    }

    /** The scene that normals of every method are lit in. */
    private Object lit() {
        LightChoice choice = model.state().choice();
        return choice.with(choice.body().withNormals(LitBody.OWN));
    }

    private String normals() {
        return model.state().choice().body().normals();
    }

    private void chooseNormals(String method) {
        model.choose(choice -> choice.with(choice.body().withNormals(method)));
    }

    private void listen() {
        Runnable noState = model.listen(state -> refresh());
        Runnable noRows = model.rows().listen(choice -> refresh());
        Runnable noBills = model.plans.bills().listen(bills -> refresh());
        unsubscribe =
                () -> {
                    noBills.run();
                    noState.run();
                    noRows.run();
                };
    }

    private RowPanel rows() {
        return new RowPanel(
                model.rows(),
                texts,
                ModeRow.names(model),
                mode -> ModeRow.choose(model, mode),
                onFailure);
    }

    private void addCard(LabLayout card, String name) {
        shown.add(card, name);
        Actions.bindUndo(card, model.history());
    }

    private Actions actions(Texts canvas, ShownPicture picture) {
        var actions = new Actions(canvas);
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(picture, onFailure);
        return actions;
    }

    /** The answers of the user's own program; empty where it lights nothing. */
    private Optional<OwnSteps> ownSteps() {
        return model.state().drawn().flatMap(LightFrame.DrawnFrame::steps);
    }

    private String orbitReading() {
        if (ownSteps().isPresent()) {
            int count = ownSteps().get().count();
            return texts.text("own.step.count", model.walk.step(count), count);
        }
        Lamp lamp = model.state().choice().lamp();
        double degrees = Math.toDegrees(Math.atan2(lamp.y(), lamp.x()));
        return texts.text("orbit", Shown.number(Math.rint(degrees), 0, texts.locale()));
    }

    private String turningReading() {
        double degrees = Math.toDegrees(model.state().color().yaw()) % 360;
        return Shown.number(Math.rint(degrees), 0, texts.locale()) + "°";
    }

    private Chips chips() {
        var chips = new Chips(texts, "hazards");
        for (LightHazard hazard : LightHazard.values()) {
            HazardCase shown =
                    HazardCase.unjudged(
                            hazard.code(),
                            texts.text("hazard." + hazard.code()),
                            texts.text("hazard." + hazard.code() + ".hint"),
                            () -> show(hazard));
            chips.add(shown);
        }
        return chips;
    }

    private void show(LightHazard hazard) {
        model.choose(choice -> hazard.shown());
        if (hazard.ofNormals())
            judge(lightGuide, hazard.code(), () -> LightVerdicts.ofNormals(hazard));
    }

    /**
     * Says that verdicts are being found once the click has shown the hazard, then the verdicts.
     */
    private void judge(
            StageGuide guide, String hazard, Supplier<Map<String, Verdict.Kind>> finding) {
        verdicts.ask(finding, found -> guide.judge(hazard, found));
        EventQueue.invokeLater(guide::judging);
    }

    /** Colours on which models or methods fail. */
    private Chips colorChips() {
        var chips = new Chips(texts, "colours.situations");
        chip(chips, "grey", 0.5, 0.5, 0.5);
        chip(chips, "black", 0, 0, 0);
        chip(chips, "nearly-grey", 0.5, 0.5, 0.501);
        chip(chips, "orange", 0.85, 0.45, 0.2);
        chip(chips, "deep-blue", 0.02, 0.01, 0.09);
        return chips;
    }

    private void chip(Chips chips, String name, double red, double green, double blue) {
        double[] rgb = {red, green, blue};
        chips.add(
                HazardCase.unjudged(
                        name,
                        texts.text("colour." + name),
                        texts.text("colour." + name + ".hint"),
                        () -> {
                            model.color(color -> withRgb(color, rgb));
                            judge(colorGuide, name, () -> LightVerdicts.ofColor(rgb));
                        }));
    }

    private static ColorChoice withRgb(ColorChoice color, double... rgb) {
        ColorChoice next = color;
        for (int i = 0; i < 3; i++) next = next.with(ColorModel.RGB, i, rgb[i]);
        return next;
    }

    /** Gives the keyboard to the picture, whose arrow keys turn the scene or the cube. */
    @Override
    public void focusPicture() {
        if (model.rows().open()) rows.focusPicture();
        else if (model.state().colors()) cube.requestFocusInWindow();
        else stage.requestFocusInWindow();
    }

    /** Stops listening and playing; the model lives on. */
    @Override
    public void close() {
        orbit.stop();
        turning.stop();
        unsubscribe.run();
        verdicts.close();
        rows.close();
    }

    @Override
    public void refresh() {
        if (model.rows().open()) {
            orbit.stop();
            turning.stop();
            rows.show();
            return;
        }
        rows.stop();
        cards.show(shown, model.state().colors() ? ModeRow.COLORS : ModeRow.LIGHT);
        if (model.state().colors()) {
            orbit.stop();
            cube.repaint();
            colors.refresh();
            turning.refresh();
            colorActions.refreshUndo();
            colorGuide.refresh();
            colorGuide.hint("light.colours", texts.text("first.colours"));
        } else {
            turning.stop();
            stage.repaint();
            light.refresh();
            orbit.refresh();
            lightActions.refreshUndo();
            lightGuide.refresh();
            boolean steps = ownSteps().isPresent();
            lightGuide.hint("light", texts.text(steps ? "first.light.own" : "first.light"));
            boolean saved = saving.commands().isPresent();
            lightActions.enable("copyCommand", model.state().drawn().isPresent());
            lightActions.hint("copyCommand", texts.text(saved ? "copy.saved" : "copy.unsaved"));
        }
    }
}
