package rasterlab.app.visibility;

import java.awt.CardLayout;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JPanel;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.file.SceneWriting;
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
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.row.RowCard;
import rasterlab.app.row.RowPanel;
import rasterlab.app.signmap.SignMaps;
import rasterlab.app.signmap.SignWindow;
import rasterlab.app.visibility.scene.HazardView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.RenderRequest;

/** The hidden-surface lab as the window shows it, in one language. */
public final class VisibilityPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    /** Pixels of a view whose verdicts are asked for before it has been drawn. */
    private static final int USUAL_WIDTH = 640;

    private static final int USUAL_HEIGHT = 480;

    private final transient VisibilityLabModel model;
    private final transient Texts texts;
    private final CardLayout cards = new CardLayout();
    private final JPanel shown = new JPanel(cards);
    private final transient RowCard rows;
    private final VisibilityStage stage;
    private final transient VisibilityInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private final transient ViewVerdicts verdicts;
    private StageGuide guide;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onFailure told what a control could not do
     */
    public VisibilityPanel(
            VisibilityLabModel model, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        setName("visibility");
        texts = Texts.of("visibility", language);
        actions = new Actions(Texts.of("canvas", language));
        var writing = new SceneWriting(this, language, actions::saved, onFailure);
        var saving = new SceneSaving(model, texts, writing::ask);
        inspector = new VisibilityInspector(model, texts, saving);
        stage = new VisibilityStage(model, texts);
        SceneRow.acceptFiles(stage, model, language);
        player =
                new StepPlayer(
                        Texts.of("canvas", language),
                        new DrawingSteps(model),
                        () -> new VisibilityReadings(model, texts).timeline());
        player.reserve(texts.text("turntable", Shown.number(1.99, texts.locale())));
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(new ShownPicture("hidden-surfaces", stage, stage::svg), onFailure);
        verdicts = new ViewVerdicts(EventQueue::invokeLater, onFailure);
        rows = new RowCard(shown, cards, () -> rows(onFailure));
        actions.addCopy("copyCommand", saving::tellCommand);
        actions.add("signMaps", () -> SignWindow.open(this, topic(), language, onFailure));
        actions.addQuestions(this::topic);
    }

    @Override
    public List<Runnable> parts() {
        var parts = new ArrayList<>(inspector.sections());
        parts.add(this::putTogether);
        return parts;
    }

    private void putTogether() {
        var scenes = new LabLayout(chips(), stage, inspector.column(), actions, player);
        guide =
                scenes.guide()
                        .of(
                                new LabInput(
                                        this::input,
                                        () -> model.state().choice().visibility(),
                                        method -> model.choose(old -> old.withVisibility(method)),
                                        VisibilityColors.OWN));
        shown.add(scenes, VisibilityMode.SCENE);
        add(shown);
        Actions.bindUndo(scenes, model.history());
        player.bindKeys(stage);
        Runnable noModel = model.listen(state -> refresh());
        Runnable noRows = model.rows().listen(choice -> showMode());
        Runnable noCharts = model.charts().listen(stage::refresh);
        Runnable noCounts = model.bills().counted().listen(bills -> inspector.refreshBills());
        Runnable noPlans = model.bills().planned().listen(bills -> refresh());
        unsubscribe =
                () -> {
                    noModel.run();
                    noRows.run();
                    noCharts.run();
                    noCounts.run();
                    noPlans.run();
                };
        showMode();
    }

    /** The topic whose steps are asked for, by what the shown method decides on. */
    private String topic() {
        return switch (model.state().choice().visibility()) {
            case "convex", "back-face" -> "visible-faces";
            case "painter", "painter-textbook", "newell" -> "depth-order";
            case OwnMethods.NAME -> model.ownTopic();
            default -> "hidden-surfaces";
        };
    }

    /** The view that every method is given. */
    private Object input() {
        return model.state().choice().withVisibility("").withComparison("");
    }

    /** Shows a view and finds what every method does there, in the size of the picture. */
    private void show(HazardView view) {
        model.choose(view::shown);
        VisibilityChoice choice = model.state().choice();
        RenderRequest sized =
                model.state()
                        .picture()
                        .map(picture -> picture.request())
                        .map(now -> choice.plain(now.width(), now.height()))
                        .orElseGet(() -> choice.plain(USUAL_WIDTH, USUAL_HEIGHT));
        verdicts.ask(sized, found -> guide.judge(view.code(), found));
        EventQueue.invokeLater(guide::judging);
    }

    /** Gives the keyboard to the picture, whose arrow keys turn the scene. */
    @Override
    public void focusPicture() {
        if (model.rows().open()) rows.focusPicture();
        else stage.requestFocusInWindow();
    }

    /** Stops listening and playing; the model lives on. */
    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
        verdicts.close();
        rows.close();
    }

    private RowPanel rows(Consumer<Throwable> onFailure) {
        return new RowPanel(
                model.rows(),
                texts,
                VisibilityMode.names(model),
                mode -> VisibilityMode.choose(model, mode),
                onFailure);
    }

    private void showMode() {
        if (model.rows().open()) {
            player.stop();
            rows.show();
        } else {
            rows.stop();
            cards.show(shown, VisibilityMode.SCENE);
        }
        inspector.refreshMode();
    }

    @Override
    public void refresh() {
        stage.refresh();
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
        actions.enable("signMaps", SignMaps.ofTopic(topic()).isPresent());
        guide.refresh();
        guide.hint("visibility", texts.text("first"));
        actions.hint(
                "copyCommand",
                texts.text(VisibilityCommand.needsFile(model) ? "copy.unsaved" : "copy.command"));
    }

    private Chips chips() {
        var chips = new Chips(texts, "hazards");
        for (HazardView view : HazardView.values())
            chips.add(
                    view.code(),
                    texts.text("hazard." + view.code()),
                    texts.text("hazard." + view.code() + ".hint"),
                    () -> show(view));
        return chips;
    }
}
