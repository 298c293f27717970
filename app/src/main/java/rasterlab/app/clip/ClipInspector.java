package rasterlab.app.clip;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.PixelMarkIcon;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.clip.outcome.ClipTopics;
import rasterlab.app.clip.outcome.Clipping;
import rasterlab.app.clip.scene.ClipMode;
import rasterlab.app.clip.scene.ClipScene;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.study.Method;

/** The clipping lab's choosers, live numbers and the explanation of the chosen method. */
final class ClipInspector {
    private final ClipLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser mode;
    private final Map<ClipMode, MethodChooser> method = new EnumMap<>(ClipMode.class);
    private final Map<ClipMode, MethodChooser> comparison = new EnumMap<>(ClipMode.class);
    private JCheckBox difference;
    private NameChooser shape;
    private VolumeControls volume;
    private JLabel tested;
    private JLabel decision;
    private JLabel from;
    private JLabel to;
    private JLabel codes;
    private JLabel verdict;
    private JLabel selected;
    private PointFields plane;
    private PointFields space;
    private JLabel missing;
    private JLabel extra;
    private JLabel worst;
    private JLabel other;
    private FormulaView matrices;
    private AboutText about;

    ClipInspector(ClipLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        column = new Inspector(texts);
        mode =
                new NameChooser(
                        "mode",
                        Stream.of(ClipMode.values()).map(ClipMode::code).toList(),
                        code -> texts.text("mode." + code),
                        code -> model.chooseMode(ClipMode.coded(code)));
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
        difference = new JCheckBox(texts.text("difference"));
        difference.setName("difference");
        difference.setToolTipText(texts.text("difference.hint"));
        difference.addActionListener(e -> model.showDifference(difference.isSelected()));
        column.wide(difference);
        shape =
                new NameChooser(
                        "shape",
                        List.of("upright", "convex"),
                        code -> texts.text("shape." + code),
                        code -> model.shapeWindow(code.equals("upright")));
        column.row("shape", shape);
        volume = new VolumeControls(model, texts, column);
    }

    private void addReadings() {
        column.heading("heading.step");
        tested = column.value("tested");
        decision = column.value("decision");
        from = column.value("from");
        to = column.value("to");
        codes = column.value("codes");
        verdict = column.value("verdict");

        column.heading("heading.wrong");
        missing = column.value("missing");
        missing.setIcon(new PixelMarkIcon(PixelMark.MISSING));
        extra = column.value("extra");
        extra.setIcon(new PixelMarkIcon(PixelMark.EXTRA));
        worst = column.value("worst");
        other = column.value("other");
    }

    private void addPoint() {
        column.heading("heading.point");
        selected = column.value("selected");
        plane = new PointFields(model, texts, false);
        space = new PointFields(model, texts, true);
        column.row("place", plane);
        column.row("place.space", space);
        column.wide(buttons());

        matrices = new FormulaView("matrices");
        column.wide(matrices);

        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private void addMethods() {
        Texts shared = Texts.of("canvas", texts.language());
        for (ClipMode each : ClipMode.values()) {
            List<String> names = model.methods(each);
            method.put(
                    each,
                    new MethodChooser("method", "", names, ClipColors.OWN, model::chooseMethod)
                            .withOwn(shared));
            comparison.put(
                    each,
                    new MethodChooser(
                                    "comparison",
                                    texts.text("none"),
                                    names,
                                    ClipColors.OWN,
                                    model::compareWith)
                            .withOwn(shared));
            column.row("method", method.get(each));
            column.row("comparison", comparison.get(each));
        }
    }

    private JPanel buttons() {
        var buttons = new JPanel(new MigLayout("insets 0, gap 6", "[grow,fill,sg][grow,fill,sg]"));
        buttons.add(button("grow", model::grow), "wmin 0");
        buttons.add(button("shrink", model::shrink), "wmin 0");
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
        ClipLabState state = model.state();
        ClipChoice choice = state.choice();
        var readings = new ClipReadings(state, texts);
        mode.show(choice.mode().code());
        for (ClipMode each : ClipMode.values()) refreshMethods(each, choice);
        difference.setVisible(!choice.scene().comparison().isEmpty());
        difference.setSelected(choice.difference());
        refreshShape(choice);
        volume.refresh(column);
        tested.setText(readings.tested());
        decision.setText(readings.decision());
        missing.setText(readings.missing());
        extra.setText(readings.extra());
        worst.setText(readings.worst());
        column.showRow(other, state.results().other().isPresent());
        other.setText(readings.other());
        selected.setText(readings.selected());
        refreshEnds(readings, state.results().scene());
        boolean inSpace = choice.mode() == ClipMode.VOLUME;
        column.showRow(plane, !inSpace);
        column.showRow(space, inSpace);
        (inSpace ? space : plane).refresh();
        matrices.setVisible(inSpace);
        if (inSpace)
            matrices.show(new VolumeFormulas(VolumeNumbers.of(choice.volume()), texts).lines());
        explain(state);
    }

    private void refreshMethods(ClipMode each, ClipChoice choice) {
        boolean shown = each == choice.mode();
        column.showRow(method.get(each), shown);
        column.showRow(comparison.get(each), shown);
        if (!shown) return;
        method.get(each).show(choice.scene().method());
        comparison.get(each).show(choice.scene().comparison());
    }

    private void refreshShape(ClipChoice choice) {
        column.showRow(shape, choice.mode() != ClipMode.VOLUME);
        boolean upright =
                choice.mode() == ClipMode.SEGMENTS
                        ? choice.segments().window().upright()
                        : choice.polygon().window().upright();
        shape.show(upright ? "upright" : "convex");
    }

    private void refreshEnds(ClipReadings readings, ClipScene scene) {
        boolean ends = scene.mode() != ClipMode.POLYGON;
        for (JComponent each : List.of(from, to, codes, verdict)) column.showRow(each, ends);
        if (!ends) return;
        from.setText(readings.from());
        to.setText(readings.to());
        codes.setText(readings.codes());
        verdict.setText(readings.verdict());
    }

    private void explain(ClipLabState state) {
        Method<?> chosen = model.method();
        TopicTexts said = TopicTexts.of(state.choice().mode().topic(), texts.language());
        about.show(
                said.texts(),
                chosen.name(),
                said.decision(chosen, ClipTopics.decisionFormula(chosen)),
                refusal(state));
    }

    /** Why the method refused: in its own words where those are the window's language. */
    private String refusal(ClipLabState state) {
        Clipping clipping = state.results().clipping();
        if (clipping.ending() != Clipping.ClipEnding.REFUSED) return "";
        if (clipping.method().equals(OwnMethods.NAME))
            return OwnWords.reason(OwnMethods.NAME, clipping.message(), texts.language());
        return texts.language() == Language.ENGLISH
                ? clipping.message()
                : ClipNotes.reason(state.results().scene(), texts);
    }
}
