package rasterlab.app.study;

import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import javax.swing.text.DefaultCaret;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.NotShown;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.study.chart.ConditionsWords;
import rasterlab.app.study.chart.LeftOutNote;
import rasterlab.app.study.chart.StudyWords;
import rasterlab.app.study.chart.TopicNames;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/** The tab's choosers, the numbers of what is chosen, and the explanation of its method. */
final class StudyInspector {
    private static final List<String> PACES = List.of("quick", "thorough");

    private final StudyLabModel model;
    private final Texts texts;
    private final Texts canvas;
    private final OpenInLab lab;
    private final StudyWords words;
    private final TopicNames called;
    private final Inspector column;
    private final NameChooser topic;
    private final NameChooser view;
    private final NameChooser pace;
    private final NameChooser workload;
    private final JLabel cost;
    private final JLabel quartiles;
    private final JLabel counted;
    private final JLabel error;
    private final JLabel wrong;
    private final JLabel verdict;
    private final JLabel recorded;
    private final JTextArea origin;
    private final JTextArea notTimed;
    private final JTextArea detail;
    private final JTextArea input;
    private final JTextArea signs;
    private final JButton open;
    private final AboutText about;

    StudyInspector(StudyLabModel model, Texts texts, OpenInLab lab, Runnable opening) {
        this.model = model;
        this.texts = texts;
        this.lab = lab;
        canvas = Texts.of("canvas", texts.language());
        words = new StudyWords(texts.language());
        called = TopicNames.in(texts.language());
        column = new Inspector(texts);
        topic =
                chooser(
                        "topic",
                        model.topics().stream().map(Topic::name).toList(),
                        called::topic,
                        model::choose);
        view =
                chooser(
                        "view",
                        List.of(),
                        code -> texts.text("view." + code),
                        code ->
                                model.show(
                                        StudyView.valueOf(
                                                code.toUpperCase(java.util.Locale.ROOT))));
        pace =
                chooser(
                        "pace",
                        PACES,
                        code -> texts.text("pace." + code),
                        code -> model.takeTime(code.equals("thorough")));
        workload =
                chooser(
                        "workload",
                        List.of(),
                        name -> words.workload(model.state().topic().name(), name),
                        model::chooseLevel);
        origin = paragraph("origin");
        column.heading("heading.chosen");
        cost = column.value("cost");
        quartiles = column.value("quartiles");
        counted = column.value("counted");
        error = column.value("error");
        verdict = column.value("verdict");
        recorded = column.value("recorded");
        wrong = column.value("wrong");
        detail = paragraph("detail");
        input = paragraph("input");
        open = KeyedControls.button("open", texts, opening);
        column.wide(open);
        signs = paragraph("signs");
        notTimed = paragraph("notTimed");
        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private NameChooser chooser(
            String key,
            List<String> names,
            java.util.function.UnaryOperator<String> said,
            java.util.function.Consumer<String> chosen) {
        var chooser = new NameChooser(key, names, said, chosen);
        column.row(key, chooser);
        return chooser;
    }

    private JTextArea paragraph(String name) {
        var paragraph = new JTextArea();
        paragraph.setName(name);
        paragraph.getAccessibleContext().setAccessibleName(texts.text(name));
        paragraph.setEditable(false);
        // A new text must not scroll the inspector.
        if (paragraph.getCaret() instanceof DefaultCaret caret)
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
        paragraph.setOpaque(false);
        paragraph.setLineWrap(true);
        paragraph.setWrapStyleWord(true);
        paragraph.setFont(UIManager.getFont("Label.font"));
        paragraph.setBorder(null);
        column.wide(paragraph);
        return paragraph;
    }

    Inspector column() {
        return column;
    }

    void refresh() {
        StudyLabState state = model.state();
        topic.show(state.topic().name());
        topic.setToolTipText(called.topic(state.topic().name()));
        view.offer(
                StudyView.of(state.topic()).stream().map(StudyView::code).toList(),
                state.view().code());
        pace.show(state.thorough() ? "thorough" : "quick");
        boolean chart = state.view().isChart();
        boolean timed = state.view() == StudyView.CHART;
        column.showRow(cost, timed);
        column.showRow(quartiles, timed);
        column.showRow(counted, chart && !timed);
        column.showRow(error, chart);
        showLevels(state);
        column.showRow(recorded, !chart);
        open.setVisible(!chart);
        input.setVisible(!chart);
        say(
                origin,
                chart
                        ? model.shippedStudy()
                                .map(new ConditionsWords(texts.language())::shipped)
                                .orElse("")
                        : "");
        say(signs, chart ? "" : texts.text("signs.meaning"));
        say(notTimed, chart ? state.study().map(this::notTimed).orElse("") : "");
        if (chart) showPoint(state);
        else showCell(state);
        explain(state);
    }

    /** Shows the workloads that were measured, in the study's order. */
    private void showLevels(StudyLabState state) {
        Optional<String> shown = state.shownLevel().filter(level -> state.view().isChart());
        column.showRow(workload, shown.isPresent());
        shown.ifPresent(level -> workload.offer(levels(state.shownStudy().orElseThrow()), level));
    }

    private static List<String> levels(Study study) {
        return study.measurements().stream()
                .filter(one -> one.cost().timed())
                .map(Measurement::workload)
                .distinct()
                .toList();
    }

    private String notTimed(Study study) {
        return String.join(" ", LeftOutNote.of(study, words).lines());
    }

    private static void say(JTextArea place, String text) {
        if (!place.getText().equals(text)) place.setText(text);
        place.setVisible(!text.isEmpty());
    }

    private void showPoint(StudyLabState state) {
        Optional<Measurement> point = state.point();
        cost.setText(
                point.map(one -> texts.text("nanos", number(one.cost().medianNanos())))
                        .orElse("–"));
        quartiles.setText(
                point.map(
                                one ->
                                        texts.text(
                                                "nanos.between",
                                                number(one.cost().lowNanos()),
                                                number(one.cost().highNanos())))
                        .orElse("–"));
        counted.setText(
                point.map(
                                one ->
                                        texts.text(
                                                "count",
                                                number(one.cost().medianNanos()),
                                                words.item(state.shownStudy().orElseThrow())))
                        .orElse("–"));
        error.setText(point.map(one -> error(state.study().orElseThrow(), one)).orElse("–"));
        verdict.setText(point.map(one -> texts.text("verdict." + one.kind().code())).orElse("–"));
        wrong.setText(point.map(one -> wrong(one.error())).orElse("–"));
        say(detail, point.map(this::detail).orElse(texts.text("hint.point")));
    }

    private String detail(Measurement point) {
        return point.detail().isEmpty()
                ? point.method()
                : words.called(point.method())
                        + ": "
                        + VerdictDetail.translated(texts.language(), point.detail());
    }

    private String error(Study study, Measurement point) {
        return point.error().worst() == 0
                ? texts.text("chart.exact")
                : words.amount(study, point.error().worst(), number(point.error().worst()));
    }

    private String wrong(Deviation deviation) {
        return deviation.of() == 0 && deviation.missing() + deviation.extra() == 0
                ? "–"
                : texts.text("wrong.counts", deviation.missing(), deviation.extra());
    }

    private void showCell(StudyLabState state) {
        if (state.hazard().isEmpty()) {
            List.of(verdict, recorded, wrong).forEach(label -> label.setText("–"));
            say(detail, texts.text("hint.cell"));
            say(input, "");
            open.setEnabled(false);
            return;
        }
        Hazard<?> hazard = model.hazard(state.hazard());
        Method<?> method = state.topic().method(state.method());
        Optional<VerdictCell> fresh = state.cell(hazard.name(), method.name());
        verdict.setText(
                fresh.map(cell -> texts.text("verdict." + cell.verdict().kind().code()))
                        .orElse(texts.text("verdict.untried")));
        recorded.setText(texts.text("verdict." + model.recorded(hazard, method)));
        wrong.setText(fresh.map(cell -> wrong(cell.verdict().deviation())).orElse("–"));
        String said = fresh.map(cell -> cell.verdict().detail()).orElse("");
        say(
                detail,
                words.called(method.name())
                        + ", "
                        + called.hazard(state.topic(), hazard)
                        + ". "
                        + topicTexts(state).hazard(hazard)
                        + (said.isEmpty()
                                ? ""
                                : "\n→ " + VerdictDetail.translated(texts.language(), said)));
        say(input, texts.text("input.is", InputText.of(hazard.input(), texts)));
        Optional<NotShown> obstacle = lab.obstacleTo(state.topic().name(), hazard.name());
        open.setEnabled(obstacle.isEmpty());
        open.setToolTipText(
                obstacle.map(why -> why.in(canvas, called.topic(state.topic().name())))
                        .orElse(texts.text("open.hint")));
    }

    private TopicTexts topicTexts(StudyLabState state) {
        return TopicTexts.of(state.topic().name(), texts.language());
    }

    private void explain(StudyLabState state) {
        Method<?> method = state.topic().method(state.method());
        TopicTexts said = topicTexts(state);
        about.show(
                List.of(
                        new AboutText.Called(
                                words.called(method.name()), said.texts(), method.name())));
    }

    private String number(double value) {
        return Shown.number(value, value < 100 ? 2 : 0, texts.locale());
    }
}
