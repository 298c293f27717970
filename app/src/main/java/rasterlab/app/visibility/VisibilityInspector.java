package rasterlab.app.visibility;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import rasterlab.app.canvas.PixelMarkIcon;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.MethodSwatch;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.plan.bill.BillTable;
import rasterlab.app.plan.least.LeastRows;
import rasterlab.app.visibility.scene.SceneChoice;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.study.Method;

/** The hidden-surface lab's choosers, live numbers and the explanation of the chosen method. */
final class VisibilityInspector {
    private static final int TABLE_HEIGHT = 150;
    private static final String TURN = "turn";
    private static final String DRAW = "draw";

    private final VisibilityLabModel model;
    private final Texts texts;
    private final Texts explanations;
    private final Inspector column;
    private final NameChooser mode;
    private final NameChooser scene;
    private final NameChooser up;
    private final MethodChooser visibility;
    private final MethodChooser comparison;
    private NameChooser shading;
    private NameChooser projection;
    private NameChooser view;
    private NameChooser timeline;
    private JCheckBox edges;
    private JCheckBox difference;
    private WrongRows wrong;
    private StepList steps;
    private JComponent stepScroll;
    private final List<JLabel> work = new ArrayList<>();
    private PixelLens lens;
    private TouchTable history;
    private JComponent historyScroll;
    private JLabel pixel;
    private JLabel stored;
    private final List<JLabel> values = new ArrayList<>();
    private LeastRows least;
    private BillTable bill;
    private JLabel noBill;
    private LookControls look;
    private AboutText about;

    VisibilityInspector(VisibilityLabModel model, Texts texts, SceneSaving saving) {
        this.model = model;
        this.texts = texts;
        explanations = TopicTexts.of("hidden-surfaces", texts.language()).texts();
        column = new Inspector(texts);
        mode = modes();
        scene = scenes();
        up = chooser("up", UpAxis.names(), name -> SceneOpening.stand(model, UpAxis.named(name)));
        column.wide(new SceneRow(model, texts, saving));
        visibility = methods("method", "", VisibilityChoice::withVisibility);
        comparison = methods("comparison", texts.text("none"), VisibilityChoice::withComparison);
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        return List.of(
                this::addDrawing,
                this::addLeast,
                this::addWrong,
                this::addOrder,
                this::addPixel,
                this::addBill,
                this::addLook,
                this::addAbout);
    }

    private void addDrawing() {
        shading = names("shading", Renderer.shadings(), VisibilityChoice::withShading);
        projection = names("projection", Renderer.projections(), VisibilityChoice::withProjection);
        view =
                names(
                        "view",
                        StageView.codes(),
                        (choice, code) -> choice.withView(StageView.coded(code)));
        timeline =
                names(
                        "timeline",
                        List.of(TURN, DRAW),
                        (choice, code) -> choice.withDrawing(code.equals(DRAW)));
        edges = box("edges", shown -> model.choose(choice -> choice.withEdges(shown)));
    }

    private void addLeast() {
        least =
                new LeastRows(
                        column,
                        texts.language(),
                        wish -> model.choose(choice -> choice.with(wish)));
    }

    private void addWrong() {
        column.heading("heading.wrong");
        difference =
                box("difference", shown -> model.choose(choice -> choice.withDifference(shown)));
        wrong = new WrongRows(column);
    }

    private void addOrder() {
        column.heading("heading.order");
        steps = new StepList(model, texts);
        stepScroll = scrolled(steps);
        for (String key : List.of("stepNow", "cuts", "comparisons", "depthTests", "pixelsWritten"))
            work.add(column.value(key));
    }

    private void addPixel() {
        column.heading("heading.pixel");
        pixel = column.value("pixel");
        stored = column.value("stored");
        lens = new PixelLens(model, texts.text("lens"));
        column.wide(lens);
        history = new TouchTable(texts);
        JScrollPane scroll = scrolled(history);
        scroll.setColumnHeaderView(history.getTableHeader());
        historyScroll = scroll;

        column.heading("heading.view");
        for (String key : List.of("theta", "phi", "rho", "zoom", "frameTime", "size"))
            values.add(column.value(key));
    }

    private void addBill() {
        column.heading("heading.bill");
        bill = new BillTable(texts.language());
        column.wide(bill.getTableHeader());
        column.wide(bill);
        noBill = new JLabel(texts.text("bill.none"));
        noBill.setName("bill.none");
        column.wide(noBill);
    }

    /** Shows the newest count, or that there is none, and the least picture. */
    void refreshBills() {
        ViewBills bills = model.bills();
        boolean there = bills.counted().bill().isPresent();
        bill.show(bills.counted());
        bill.setVisible(there);
        bill.getTableHeader().setVisible(there);
        noBill.setVisible(bills.counted().current() && !there);
        VisibilityChoice choice = model.state().choice();
        least.show(
                choice.least(),
                choice.tolerance().isPresent(),
                model.state().picture().flatMap(Picture::planned),
                bills.planned());
    }

    private void addLook() {
        column.heading("heading.look");
        look = new LookControls(model, texts, column);
    }

    private void addAbout() {
        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private NameChooser modes() {
        var modes =
                new NameChooser(
                        "mode",
                        VisibilityMode.names(model),
                        name -> TopicTexts.mode(texts, name),
                        name -> VisibilityMode.choose(model, name));
        column.row("mode", modes);
        modes.show(VisibilityMode.SCENE);
        return modes;
    }

    /** Shows the mode again, which in the lab of scenes is always that one. */
    void refreshMode() {
        mode.show(VisibilityMode.SCENE);
    }

    private NameChooser scenes() {
        var names = new ArrayList<String>(Scenes.names());
        SceneChoice shown = model.state().choice().shown();
        if (!names.contains(shown.name())) names.add(shown.name());
        return chooser("scene", names, this::chooseScene);
    }

    /** A scene that is open already may have no name to be looked up. */
    private void chooseScene(String name) {
        if (!name.equals(model.state().choice().scene()))
            model.choose(choice -> choice.withScene(name));
    }

    private JScrollPane scrolled(JComponent inner) {
        var scroll = new JScrollPane(inner);
        scroll.setName(inner.getName() + ".scroll");
        scroll.setPreferredSize(new Dimension(100, UIScale.scale(TABLE_HEIGHT)));
        column.wide(scroll);
        return scroll;
    }

    private interface Change {
        VisibilityChoice of(VisibilityChoice choice, String name);
    }

    private MethodChooser methods(String key, String none, Change change) {
        List<String> names = model.methods().stream().map(Method::name).toList();
        var chooser =
                new MethodChooser(
                        key,
                        none,
                        names,
                        VisibilityColors.OWN,
                        name -> model.choose(choice -> change.of(choice, name)));
        chooser.withOwn(Texts.of("canvas", texts.language()));
        column.row(key, chooser);
        return chooser;
    }

    private NameChooser names(String key, List<String> names, Change change) {
        return chooser(key, names, name -> model.choose(choice -> change.of(choice, name)));
    }

    private NameChooser chooser(String key, List<String> names, Consumer<String> chosen) {
        var chooser =
                new NameChooser(key, names, name -> texts.textOr(key + "." + name, name), chosen);
        column.row(key, chooser);
        return chooser;
    }

    private JCheckBox box(String key, Consumer<Boolean> chosen) {
        JCheckBox box = KeyedControls.box(key, texts, chosen);
        column.wide(box);
        return box;
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        VisibilityLabState state = model.state();
        VisibilityChoice choice = state.choice();
        var readings = new VisibilityReadings(model, texts);
        showScene(choice.shown());
        visibility.show(choice.visibility());
        comparison.show(choice.comparison());
        shading.show(choice.shading());
        projection.show(choice.projection());
        view.show(choice.view().code());
        timeline.show(choice.drawing() ? DRAW : TURN);
        edges.setSelected(choice.edges());
        edges.setEnabled(model.canDrawEdges());
        difference.setSelected(choice.difference());
        wrong.show(readings, choice);
        refreshSteps(choice.drawing() && !state.lent() && !model.lacksSteps(), readings);
        refreshPixel(state, readings);
        List<String> texts = readings.view();
        for (int i = 0; i < texts.size(); i++) values.get(i).setText(texts.get(i));
        refreshBills();
        look.refresh();
        boolean own = choice.visibility().equals(OwnMethods.NAME);
        if (own || model.methods().stream().anyMatch(one -> one.name().equals(choice.visibility())))
            about.show(explanations, choice.visibility(), readings.decision(), "");
    }

    /** A scene without a name of its own is in the list as long as it is shown. */
    private void showScene(SceneChoice shown) {
        scene.showListed(shown.name(), Scenes.names());
        up.show(shown.up().orElse(UpAxis.Y).code());
        column.showRow(up, shown.up().isPresent());
    }

    private void refreshSteps(boolean watched, VisibilityReadings readings) {
        stepScroll.setVisible(watched);
        steps.refresh();
        List<String> texts = readings.work();
        for (int i = 0; i < texts.size(); i++) {
            work.get(i).setText(texts.get(i));
            column.showRow(work.get(i), i == 0 || watched);
        }
    }

    private void refreshPixel(VisibilityLabState state, VisibilityReadings readings) {
        boolean chosen = state.chosen().isPresent();
        pixel.setText(readings.pixel());
        column.showRow(
                stored, state.pixel().isPresent() && state.pixel().get().stored().isPresent());
        stored.setText(readings.stored());
        lens.setVisible(chosen);
        lens.repaint();
        historyScroll.setVisible(chosen);
        state.pixel().ifPresent(report -> history.show(report.touches()));
        if (!chosen) history.show(List.of());
    }

    /**
     * The differences from the exact picture, by the kinds of marks; of a second method only how
     * many.
     */
    private static final class WrongRows {
        private final Inspector column;
        private final JLabel wrongPixels;
        private final JLabel missing;
        private final JLabel extra;
        private final JLabel miscolored;
        private final JLabel share;
        private final JLabel largest;
        private final JLabel other;

        WrongRows(Inspector column) {
            this.column = column;
            wrongPixels = column.value("wrongPixels");
            missing = column.value("missing");
            missing.setIcon(new PixelMarkIcon(PixelMark.MISSING));
            extra = column.value("extra");
            extra.setIcon(new PixelMarkIcon(PixelMark.EXTRA));
            miscolored = column.value("miscoloured");
            miscolored.setIcon(new WrongFaceIcon());
            share = column.value("share");
            largest = column.value("largest");
            other = column.value("other");
        }

        void show(VisibilityReadings readings, VisibilityChoice choice) {
            boolean two = !choice.comparison().isEmpty();
            wrongPixels.setText(readings.wrongPixels());
            wrongPixels.setToolTipText(readings.refusal().orElse(null));
            wrongPixels.setIcon(
                    two ? new MethodSwatch(choice.visibility(), VisibilityColors.OWN) : null);
            missing.setText(readings.missing());
            extra.setText(readings.extra());
            miscolored.setText(readings.miscolored());
            share.setText(readings.share());
            largest.setText(readings.largest());
            other.setText(readings.other());
            other.setToolTipText(readings.otherRefusal().orElse(null));
            other.setIcon(two ? new MethodSwatch(choice.comparison(), VisibilityColors.OWN) : null);
            for (JLabel each : List.of(missing, extra, miscolored, share, largest))
                column.showRow(each, choice.difference());
            column.showRow(other, two);
        }
    }
}
