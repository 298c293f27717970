package rasterlab.app.line;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import rasterlab.app.canvas.PixelMarkIcon;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.KeyedControls;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.ArcFigure;
import rasterlab.app.line.figure.Dashes;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.figure.FigureScene;
import rasterlab.app.line.figure.FigureState;
import rasterlab.app.line.figure.FigureTopics;
import rasterlab.app.line.figure.PenFigure;
import rasterlab.app.line.figure.SlopeFigure;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.app.line.trace.SingleMethodMark;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.raster.PixelMark;

/** Choosers, numbers and live readings of the figures, and the chosen method explained. */
final class FigureInspector {
    private final FigureLabModel model;
    private final Texts texts;
    private final Inspector column;
    private final NameChooser mode;
    private final Map<LineMode, MethodChooser> method = new EnumMap<>(LineMode.class);
    private final Map<LineMode, MethodChooser> comparison = new EnumMap<>(LineMode.class);
    private final ArcFields fields;
    private final NumberSlider width;
    private final JCheckBox round;
    private final NameChooser dashes;
    private final JLabel pixel;
    private final JLabel offset;
    private final JLabel decision;
    private final JLabel missing;
    private final JLabel extra;
    private final JLabel again;
    private final JLabel worst;
    private final JLabel length;
    private final JLabel lit;
    private final JLabel angle;
    private final JLabel light;
    private final JLabel full;
    private final JLabel spread;
    private final JLabel other;
    private final JLabel apart;
    private final AboutText about;

    FigureInspector(LineLabModel lab, Texts texts) {
        this.texts = texts;
        model = lab.figures();
        column = new Inspector(texts);
        mode = ModeChooser.of(LineMode.CIRCLE, lab, texts);
        column.row("mode", mode);
        addMethods();
        fields = new ArcFields(model, texts);
        column.row("centre", fields.center());
        column.row("radii", fields.radii());
        width =
                new NumberSlider(
                        "width",
                        texts.text("width.hint"),
                        PenFigure.NARROWEST,
                        PenFigure.WIDEST,
                        false,
                        23,
                        value -> model.pen(old -> old.withWidth(value)));
        column.row("width", width);
        dashes =
                new NameChooser(
                        "dashes",
                        Stream.of(Dashes.values()).map(Dashes::code).toList(),
                        code -> texts.text("dashes." + code),
                        code -> model.pen(old -> old.withDashes(Dashes.coded(code))));
        column.row("dashes", dashes);
        round =
                KeyedControls.box(
                        "round", texts, rounded -> model.pen(old -> old.withRound(rounded)));
        column.wide(round);

        column.heading("heading.numbers");
        pixel = column.value("pixel");
        offset = column.value("offset");
        decision = column.value("decision");
        missing = marked("missing", PixelMark.MISSING);
        extra = marked("extra", PixelMark.EXTRA);
        again = marked("again", PixelMark.AGAIN);
        again.setToolTipText(texts.text("again.hint"));
        worst = column.value("worst");
        length = column.value("length");
        lit = column.value("lit");
        angle = column.value("angle");
        light = column.value("light");
        full = column.value("full");
        spread = column.value("spread");
        other = column.value("other");
        apart = column.value("apart");
        apart.setIcon(new SingleMethodMark());
        apart.setToolTipText(texts.text("apart.hint"));

        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private JLabel marked(String key, PixelMark mark) {
        JLabel count = column.value(key);
        count.setIcon(new PixelMarkIcon(mark));
        return count;
    }

    private void addMethods() {
        Texts shared = Texts.of("canvas", texts.language());
        for (LineMode each : List.of(LineMode.CIRCLE, LineMode.ELLIPSE, LineMode.BRIGHTNESS)) {
            List<String> names = model.methods(each);
            method.put(
                    each,
                    new MethodChooser("method", "", names, LineColors.OWN, model::chooseMethod)
                            .withOwn(shared));
            comparison.put(
                    each,
                    new MethodChooser(
                                    "comparison",
                                    texts.text("none"),
                                    names,
                                    LineColors.OWN,
                                    model::compareWith)
                            .withOwn(shared));
            column.row("method", method.get(each));
            column.row("comparison", comparison.get(each));
        }
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        FigureState state = model.state();
        FigureScene scene = state.scene();
        mode.show(scene.mode().code());
        method.forEach(
                (each, chooser) -> {
                    boolean shown = each == scene.mode();
                    column.showRow(chooser, shown);
                    column.showRow(comparison.get(each), shown);
                    if (!shown) return;
                    chooser.show(scene.method());
                    comparison.get(each).show(scene.comparison());
                });
        boolean arc = scene.figure() instanceof ArcFigure;
        column.showRow(fields.center(), arc);
        column.showRow(fields.radii(), arc);
        if (scene.figure() instanceof ArcFigure shown) showArc(shown);
        boolean pen = scene.figure() instanceof PenFigure;
        for (JComponent each : List.of(width, dashes)) column.showRow(each, pen);
        round.setVisible(pen);
        if (scene.figure() instanceof PenFigure shown) showPen(shown);
        refreshReadings(state);
        explain(state);
    }

    private void showArc(ArcFigure shown) {
        fields.show(shown);
        column.nameRow(fields.radii(), shown.round() ? "radius" : "radii");
    }

    private void showPen(PenFigure shown) {
        width.show(
                shown.width(),
                texts.text("worst.pixels", Shown.number(shown.width(), 1, texts.locale())));
        dashes.show(shown.dashes().code());
        round.setSelected(shown.round());
    }

    private void refreshReadings(FigureState state) {
        boolean arc = state.drawn().figure() instanceof ArcFigure;
        for (JLabel each : List.of(pixel, offset, decision, missing, extra, worst))
            column.showRow(each, arc);
        boolean slope = state.drawn().figure() instanceof SlopeFigure;
        for (JLabel each : List.of(angle, light, full, spread)) column.showRow(each, slope);
        column.showRow(other, state.other().isPresent());
        var readings = new FigureReadings(state, texts);
        column.showRow(again, arc && readings.repeats());
        if (arc) {
            pixel.setText(readings.pixel());
            offset.setText(readings.offset());
            decision.setText(readings.decision());
            missing.setText(readings.missing());
            extra.setText(readings.extra());
            again.setText(readings.again());
            worst.setText(readings.worst());
        }
        boolean pen = state.drawn().figure() instanceof PenFigure;
        for (JLabel each : List.of(length, lit)) column.showRow(each, pen);
        length.setText(readings.length());
        lit.setText(readings.lit());
        angle.setText(readings.angle());
        if (slope) {
            light.setText(readings.light());
            full.setText(readings.full());
            spread.setText(readings.spread());
        }
        other.setText(readings.other());
        column.showRow(apart, state.drawings().apart().isPresent());
        apart.setText(readings.apart());
    }

    private void explain(FigureState state) {
        model.method()
                .ifPresentOrElse(
                        chosen -> {
                            LineMode shown = state.scene().mode();
                            String topic = shown == LineMode.BRIGHTNESS ? "line" : shown.code();
                            TopicTexts said = TopicTexts.of(topic, texts.language());
                            about.show(
                                    said.texts(),
                                    chosen.name(),
                                    said.decision(chosen, FigureTopics.decisionFormula(chosen)),
                                    refusal(state));
                        },
                        () -> about.show(texts, "pen", "", ""));
    }

    /** Why the method refused: in its own words where those are the window's language. */
    private String refusal(FigureState state) {
        if (state.drawing().ending() != LineTrace.TraceEnding.REFUSED) return "";
        if (state.scene().method().equals(OwnMethods.NAME))
            return OwnWords.reason(OwnMethods.NAME, state.drawing().message(), texts.language());
        return texts.language() == Language.ENGLISH
                ? state.drawing().message()
                : texts.text("figure.refusal");
    }
}
