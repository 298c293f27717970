package rasterlab.app.spline;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneEdits;
import rasterlab.app.canvas.PlaneView;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.Chips;
import rasterlab.app.canvas.lab.LabInput;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.card.TopicChips;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Method;

/** The lab of curves as the tab shows it, in one language. */
final class CurvePanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private final transient CurveLabModel model;
    private final transient Texts texts;
    private final PlaneView stage;
    private final transient CurveInspector inspector;
    private final StepPlayer player;
    private final Actions actions;
    private StageGuide guide;
    private transient Runnable unsubscribe = () -> {};

    /**
     * @param onMode told when the other lab is chosen
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    CurvePanel(
            CurveLabModel model,
            Language language,
            Consumer<SplineMode> onMode,
            Consumer<Throwable> onFailure) {
        this.model = model;
        setName("curve");
        texts = Texts.of("spline", language);
        Texts canvas = Texts.of("canvas", language);
        stage =
                new PlaneView(
                        PlaneAxes.RASTER,
                        canvas,
                        texts.text("stage.curve"),
                        new Edits(),
                        model::settle,
                        onFailure);
        inspector = new CurveInspector(model, texts, onMode);
        player =
                new StepPlayer(
                        canvas, model, () -> texts.text("count", model.step(), model.last()));
        actions = new Actions(canvas);
        actions.addUndo(model.history());
        actions.add("reset", model::reset);
        actions.addPicture(new ShownPicture("curve", stage, stage::svg), onFailure);
        actions.addCopy(
                "copyCommand", told -> told.accept(CurveCommand.of(model.state().choice())));
        actions.addQuestions(() -> "curve");
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
                        .of(
                                new LabInput(
                                        this::input,
                                        () -> model.state().choice().method(),
                                        model::chooseMethod,
                                        SplineColors.OWN));
        add(layout);
        Actions.bindUndo(this, model.history());
        player.bindKeys(stage);
        unsubscribe = model.listen(state -> refresh());
    }

    /** Gives the keyboard to the point that had it last. */
    @Override
    public void focusPicture() {
        stage.focusPoint();
    }

    @Override
    public void stop() {
        player.stop();
    }

    /** Stops listening and playing; the model lives on. */
    @Override
    public void close() {
        player.stop();
        unsubscribe.run();
        stage.close();
    }

    @Override
    public void refresh() {
        CurveLabState state = model.state();
        var readings = new CurveReadings(state, texts);
        Extent all = state.choice().extent();
        stage.show(
                new CurvePicture(state.drawings(), state.at(), state.step()),
                readings.points(),
                readings.note(),
                new Rectangle2D.Double(all.x(), all.y(), all.width(), all.height()),
                state.arrangement());
        inspector.refresh();
        player.refresh();
        actions.refreshUndo();
        guide.refresh();
        guide.hint("spline.curve", texts.text("first.curve"));
    }

    /** The question that is put to every method. */
    private Object input() {
        CurveChoice choice = model.state().choice();
        return List.of(choice.form(), choice.points(), choice.joining(), choice.sampling());
    }

    private Chips chips() {
        return TopicChips.of(
                texts,
                "curve",
                model.hazards(),
                model.methods().stream().map(Method::name).toList(),
                hazard -> model.show(hazard.input()));
    }

    private final class Edits implements PlaneEdits {
        @Override
        public void beginDrag() {
            model.beginDrag();
        }

        @Override
        public void endDrag() {
            model.endDrag();
        }

        @Override
        public void move(String point, double x, double y) {
            model.move(number(point), x, y);
        }

        @Override
        public void add(double x, double y) {
            model.add(x, y);
        }

        @Override
        public void remove(String point) {
            model.remove(number(point));
        }

        /** The N of {@code point.N}. */
        private static int number(String point) {
            return Integer.parseInt(point.substring(point.indexOf('.') + 1));
        }
    }
}
