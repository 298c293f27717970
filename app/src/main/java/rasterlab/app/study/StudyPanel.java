package rasterlab.app.study;

import java.awt.CardLayout;
import java.awt.Insets;
import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.KeyStroke;
import javax.swing.filechooser.FileNameExtensionFilter;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.SvgDrawing;
import rasterlab.app.canvas.file.FileWriting;
import rasterlab.app.canvas.file.SaveChooser;
import rasterlab.app.canvas.file.ShownPicture;
import rasterlab.app.canvas.lab.Actions;
import rasterlab.app.canvas.lab.LabLayout;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.RunButtons;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.study.chart.ConditionsWords;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.StudyWork;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.app.study.front.FrontChart;
import rasterlab.app.study.front.StudyPlot;
import rasterlab.engine.study.Study;

/** Speed and accuracy as the window shows them, in one language. */
public final class StudyPanel extends LabPanel {
    private static final long serialVersionUID = 1L;

    private static final Insets MARGIN = new Insets(2, 10, 2, 10);

    /** The card of all charts. */
    private static final String CHARTS = "charts";

    private final transient StudyLabModel model;
    private final transient OpenInLab lab;
    private final transient Texts texts;
    private final transient TopicNames called;
    private final transient StudyWords words;
    private final transient Consumer<Throwable> onFailure;
    private final transient FileWriting writing;
    private final ChartStage chart;
    private final HazardTable table;
    private final CardLayout cards = new CardLayout();
    private final JPanel stage = new JPanel(cards);
    private final transient StudyInspector inspector;
    private final Actions actions;
    private final JButton measure;
    private final JButton hazards;
    private final JButton cancel;
    private final transient RunButtons runButtons;
    private final JButton save;
    private final JProgressBar progress = new JProgressBar();
    private final StageGuide guide;
    private final transient Runnable unsubscribe;

    /**
     * @param lab shows a hazard in its topic's tab
     * @param onFailure told what a control could not do or painting threw, on any thread
     */
    public StudyPanel(
            StudyLabModel model, OpenInLab lab, Language language, Consumer<Throwable> onFailure) {
        this.model = model;
        this.lab = lab;
        this.onFailure = onFailure;
        setName("study");
        texts = Texts.of("study", language);
        called = TopicNames.in(language);
        words = new StudyWords(language);
        writing = new FileWriting(this, language, onFailure);
        chart = new ChartStage(model, texts, onFailure);
        table = new HazardTable(model, texts, this::open);
        inspector = new StudyInspector(model, texts, lab, this::open);
        measure = button("measure", this::measure);
        hazards = button("tryHazards", this::tryHazards);
        cancel = button("cancel", model::cancel);
        runButtons = new RunButtons(List.of(measure, hazards), cancel, this::focusPicture);
        save = button("save", this::saveStudy);
        actions = new Actions(Texts.of("canvas", language));
        actions.addPicture(
                new ShownPicture("study", this::dots, this::svg, Runnable::run), onFailure);
        actions.addCopy("copyCommand", told -> told.accept(command()));
        stage.setName("stage");
        stage.add(chart, CHARTS);
        stage.add(table.scroll(), StudyView.HAZARDS.code());
        var layout = new LabLayout(bar(), stage, inspector.column(), actions, timeline());
        guide = layout.guide().dock();
        add(layout);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), model::cancel);
        unsubscribe = model.listen(state -> refresh());
    }

    private JButton button(String key, Runnable action) {
        JButton button = KeyedControls.button(key, texts, action);
        button.setMargin(MARGIN);
        return button;
    }

    private JPanel bar() {
        var bar = new JPanel(new FlowRows(6));
        bar.add(measure);
        bar.add(hazards);
        bar.add(cancel);
        bar.add(save);
        FlowRows.keepWrapped(bar);
        return bar;
    }

    private JComponent timeline() {
        progress.setName("progress");
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName(texts.text("progress"));
        var timeline = new JPanel(new MigLayout("insets 0 0 4 0", "[grow,fill]", "[22!]"));
        timeline.add(progress, "wmin 0, grow");
        return timeline;
    }

    /** Gives the keyboard to the chart or the table, whichever is shown. */
    @Override
    public void focusPicture() {
        if (model.state().view().isChart()) chart.requestFocusInWindow();
        else table.requestFocusInWindow();
    }

    /** Stops listening; what is being measured goes on in the model. */
    @Override
    public void close() {
        unsubscribe.run();
        chart.close();
    }

    private void measure() {
        if (!model.state().view().isChart()) model.show(StudyView.CHART);
        model.measure();
    }

    private void tryHazards() {
        model.show(StudyView.HAZARDS);
        model.tryHazards();
    }

    private void open() {
        StudyLabState state = model.state();
        if (state.hazard().isEmpty()) return;
        if (lab.obstacleTo(state.topic().name(), state.hazard()).isPresent()) return;
        try {
            lab.showHazard(state.topic().name(), state.hazard(), state.method());
        } catch (IllegalArgumentException e) {
            onFailure.accept(e);
        }
    }

    private BufferedImage dots() {
        return model.state().view() == StudyView.HAZARDS
                ? table.dots()
                : ShownPicture.dotsOf(chart);
    }

    private SvgDrawing svg() {
        if (model.state().view() == StudyView.HAZARDS) return table.svg();
        Study study = model.state().shownStudy().orElseThrow();
        String level = model.state().shownLevel().orElseThrow();
        ChartLook paper = ChartLook.PAPER;
        StudyWords said = cost().words(texts.language());
        var front = new FrontChart(study, level, said, paper);
        return () -> new String(front.svg(paper), StandardCharsets.UTF_8);
    }

    private StudyCost cost() {
        return model.state().view().cost().orElseThrow();
    }

    private String command() {
        return StudyLabCommand.of(model.state(), texts.language());
    }

    private void saveStudy() {
        Study study = model.state().study().orElseThrow();
        var chooser = new SaveChooser(texts.language(), file -> file);
        chooser.setDialogTitle(texts.text("save.title"));
        chooser.setFileFilter(
                new FileNameExtensionFilter(texts.text("save.kinds"), "svg", "png", "csv", "json"));
        chooser.toSave(this, "study-" + study.topic() + ".svg")
                .ifPresent(file -> write(study, file));
    }

    private void write(Study study, Path file) {
        StudyCost cost = cost();
        writing.write(
                texts.text("save.title"),
                () -> {
                    StudyFile.write(study, StudyPlot.FRONT, cost, file, texts.language());
                    return file;
                },
                done -> {});
    }

    @Override
    public void refresh() {
        StudyLabState state = model.state();
        runButtons.refresh(state.work().running());
        boolean drawn = state.study().isPresent() || state.view() == StudyView.HAZARDS;
        save.setEnabled(state.study().isPresent() && state.view().isChart());
        actions.enable("savePicture", drawn);
        actions.enable("copyPicture", drawn);
        actions.enable("copySvg", drawn);
        cards.show(stage, state.view().isChart() ? CHARTS : state.view().code());
        chart.refresh();
        table.refresh();
        inspector.refresh();
        boolean tried = state.work().running() || state.study().isPresent();
        guide.hint("study", tried ? "" : texts.text("first"));
        show(state);
    }

    private void show(StudyLabState state) {
        StudyWork work = state.work();
        progress.setMaximum(Math.max(1, work.of()));
        progress.setValue(work.done());
        if (work.running()) progress.setString(words.progress(work, at(work)));
        else progress.setString(resting(state));
        progress.setToolTipText(progress.getString());
    }

    /** The last finished result. */
    private String at(StudyWork work) {
        if (work.method().isEmpty()) return "";
        boolean hazard = work.kind() == StudyWork.Kind.HAZARDS;
        String on =
                hazard
                        ? called.hazard(model.state().topic(), model.hazard(work.on()))
                        : words.workload(model.state().topic().name(), work.on());
        return work.method() + ", " + on;
    }

    private String resting(StudyLabState state) {
        StudyWork work = state.work();
        if (work.kind() == StudyWork.Kind.GIVEN_UP) return texts.text("progress.givenUp");
        String why = Complaints.translated(texts.language(), work.on());
        if (work.kind() == StudyWork.Kind.NOT_KEPT) return texts.text("progress.notKept", why);
        if (work.kind() == StudyWork.Kind.NOT_READ) return texts.text("progress.notRead", why);
        if (state.view().isChart())
            return model.shippedStudy()
                    .map(shipped -> texts.text("progress.shipped"))
                    .or(() -> state.study().map(this::measured))
                    .orElse(texts.text("progress.none"));
        return texts.text(state.cells().isEmpty() ? "progress.untried" : "progress.tried");
    }

    private String measured(Study study) {
        return conditions().measuredOn(study).orElse(texts.text("progress.measured"));
    }

    private ConditionsWords conditions() {
        return new ConditionsWords(texts.language());
    }
}
