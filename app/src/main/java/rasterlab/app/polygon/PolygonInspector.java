package rasterlab.app.polygon;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.PixelMarkIcon;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.LargeType;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.SeedFigure;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.PolygonTopics;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.study.Method;

/** The lab's choosers, live numbers and the explanation of the chosen method. */
final class PolygonInspector {
    private final PolygonLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser mode;
    private final Map<PolygonMode, MethodChooser> method = new EnumMap<>(PolygonMode.class);
    private final Map<PolygonMode, MethodChooser> comparison = new EnumMap<>(PolygonMode.class);
    private JCheckBox difference;
    private FigureControls controls;
    private JLabel tested;
    private JLabel decision;
    private JLabel verdict;
    private JLabel work;
    private FormulaView formulas;
    private WaitingChart waiting;
    private JLabel missing;
    private JLabel extra;
    private JLabel faulty;
    private JLabel worst;
    private JLabel other;
    private JLabel selected;
    private PlaceFields place;
    private JButton next;
    private JPanel changes;
    private JPanel walls;
    private AboutText about;

    PolygonInspector(PolygonLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        column = new Inspector(texts);
        mode =
                new NameChooser(
                        "mode",
                        Stream.of(PolygonMode.values()).map(PolygonMode::code).toList(),
                        code -> texts.text("mode." + code),
                        code -> model.chooseMode(PolygonMode.coded(code)));
        column.row("mode", mode);
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        return List.of(this::addMethods, this::addFigure, this::addReadings, this::addPoint);
    }

    private void addFigure() {
        difference = KeyedControls.box("difference", texts, model::showDifference);
        column.wide(difference);
        controls = new FigureControls(model, texts, column);
    }

    private void addReadings() {
        column.heading("heading.step");
        tested = column.value("tested");
        decision = column.value("decision");
        verdict = column.value("verdict");
        work = column.value("work");
        formulas = new FormulaView("formulas");
        column.wide(formulas);
        waiting = new WaitingChart(texts);
        column.wide(waiting);

        column.heading("heading.wrong");
        missing = column.value("missing");
        missing.setIcon(new PixelMarkIcon(PixelMark.MISSING));
        extra = column.value("extra");
        extra.setIcon(new PixelMarkIcon(PixelMark.EXTRA));
        faulty = column.value("faulty");
        worst = column.value("worst");
        other = column.value("other");
    }

    private void addPoint() {
        column.heading("heading.point");
        selected = column.value("selected");
        place = new PlaceFields(model, texts);
        column.row("place", place);
        changes = buttons(button("grow", model::grow), button("shrink", model::shrink));
        walls = buttons(button("wall", model::grow), button("clear", model::shrink));
        next = button("next", model::nextPoint);
        column.wide(changes);
        column.wide(walls);
        column.wide(next);

        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private void addMethods() {
        Texts shared = Texts.of("canvas", texts.language());
        for (PolygonMode each : PolygonMode.values()) {
            List<String> names = model.methods(each);
            method.put(
                    each,
                    new MethodChooser("method", "", names, PolygonColors.OWN, model::chooseMethod)
                            .withOwn(shared));
            comparison.put(
                    each,
                    new MethodChooser(
                                    "comparison",
                                    texts.text("none"),
                                    names,
                                    PolygonColors.OWN,
                                    model::compareWith)
                            .withOwn(shared));
            column.row("method", method.get(each));
            column.row("comparison", comparison.get(each));
        }
    }

    private static JPanel buttons(JButton one, JButton other) {
        var buttons =
                new JPanel(
                        LargeType.now()
                                ? new MigLayout("insets 0, gap 6, wrap 1", "[grow,fill]")
                                : new MigLayout("insets 0, gap 6", "[grow,fill,sg][grow,fill,sg]"));
        buttons.add(one, "wmin 0");
        buttons.add(other, "wmin 0");
        return buttons;
    }

    private JButton button(String key, Runnable action) {
        var button = new JButton(texts.label(key));
        button.setName(key);
        button.setToolTipText(texts.text(key + ".hint"));
        button.addActionListener(e -> action.run());
        return button;
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        PolygonLabState state = model.state();
        PolygonChoice choice = state.choice();
        PolygonFigure figure = choice.scene().figure();
        mode.show(choice.mode().code());
        for (PolygonMode each : PolygonMode.values()) refreshMethods(each, choice);
        difference.setVisible(!choice.scene().comparison().isEmpty());
        difference.setSelected(choice.difference());
        controls.refresh(figure, column);
        refreshNumbers(state);
        boolean corners = figure.grips().containsKey(Grip.corner(0));
        changes.setVisible(corners && choice.mode() != PolygonMode.TRIANGLE);
        walls.setVisible(figure instanceof SeedFigure);
        next.setVisible(figure instanceof InsideFigure inside && inside.points().size() > 1);
        place.refresh();
        explain(state);
    }

    private void refreshMethods(PolygonMode each, PolygonChoice choice) {
        boolean shown = each == choice.mode();
        column.showRow(method.get(each), shown);
        column.showRow(comparison.get(each), shown);
        if (!shown) return;
        method.get(each).show(choice.scene().method());
        comparison.get(each).show(choice.scene().comparison());
    }

    private void refreshNumbers(PolygonLabState state) {
        var readings = new PolygonReadings(state, texts);
        PolygonMode shown = state.results().scene().mode();
        tested.setText(readings.tested());
        decision.setText(readings.decision());
        column.nameRow(decision, readings.decides());
        column.showRow(verdict, shown.judges());
        verdict.setText(readings.verdict());
        column.showRow(work, !shown.judges());
        work.setText(readings.work());
        formulas.show(readings.formulas());
        formulas.setVisible(!readings.formulas().isEmpty());
        waiting.setVisible(shown == PolygonMode.SEED);
        MethodOutcome outcome = state.results().outcome();
        if (shown == PolygonMode.SEED && outcome.answer() instanceof PixelAnswer answer)
            waiting.show(answer.runs(), outcome.method(), state.step());
        missing.setText(readings.missing());
        extra.setText(readings.extra());
        boolean cut = shown == PolygonMode.TRIANGULATION;
        column.showRow(missing, !cut);
        column.showRow(extra, !cut);
        column.showRow(faulty, cut);
        faulty.setText(readings.faulty());
        worst.setText(readings.worst());
        worst.setToolTipText(shown.judges() ? texts.text("worst.hint") : null);
        column.showRow(other, state.results().other().isPresent());
        other.setText(readings.other());
        selected.setText(readings.selected());
    }

    private void explain(PolygonLabState state) {
        Method<?> chosen = model.method();
        TopicTexts said = TopicTexts.of(state.choice().mode().topic(), texts.language());
        about.show(
                said.texts(),
                chosen.name(),
                said.decision(chosen, PolygonTopics.decisionFormula(chosen)),
                refusal(state));
    }

    /** Why the method refused: in its own words where those are the window's language. */
    private String refusal(PolygonLabState state) {
        MethodOutcome outcome = state.results().outcome();
        if (outcome.ending() != MethodOutcome.MethodEnding.REFUSED) return "";
        if (outcome.method().equals(OwnMethods.NAME))
            return OwnWords.reason(OwnMethods.NAME, outcome.message(), texts.language());
        return texts.language() == Language.ENGLISH
                ? outcome.message()
                : PolygonNotes.reason(state.results().scene().figure(), outcome, texts);
    }
}
