package rasterlab.app.line;

import java.util.List;
import javax.swing.JLabel;
import rasterlab.app.canvas.PixelMarkIcon;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.line.trace.LineTrace;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.line.SteppedLine;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.study.Method;

/** The line lab's choosers, live numbers and the explanation of the chosen method. */
final class LineInspector {
    private final LineLabModel model;
    private final Texts texts;
    private final TopicTexts said;
    private final Inspector column;
    private EndFields a;
    private EndFields b;
    private final MethodChooser method;
    private final MethodChooser comparison;
    private JLabel pixel;
    private JLabel coverage;
    private JLabel decision;
    private JLabel decided;
    private JLabel compared;
    private JLabel missing;
    private JLabel extra;
    private JLabel worst;
    private JLabel other;
    private JLabel tried;
    private JLabel apart;
    private AboutText about;

    LineInspector(LineLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        said = TopicTexts.of("line", texts.language());
        column = new Inspector(texts);
        List<String> names = model.methods().stream().map(Method::name).toList();

        column.row("mode", ModeChooser.of(LineMode.SEGMENT, model, texts));
        Texts shared = Texts.of("canvas", texts.language());
        method =
                new MethodChooser("method", "", names, LineColors.OWN, model::chooseMethod)
                        .withOwn(shared);
        comparison =
                new MethodChooser(
                                "comparison",
                                texts.text("none"),
                                names,
                                LineColors.OWN,
                                model::compareWith)
                        .withOwn(shared);
        column.row("method", method);
        column.row("comparison", comparison);
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        return List.of(this::addEnds, this::addReadings, this::addAbout);
    }

    private void addEnds() {
        a = new EndFields(End.A, model, texts);
        b = new EndFields(End.B, model, texts);
        column.row("end.a", a);
        column.row("end.b", b);
    }

    private void addReadings() {
        column.heading("heading.step");
        pixel = column.value("pixel");
        coverage = column.value("coverage");
        decision = column.value("decision");
        decided = column.value("decided");

        column.heading("heading.wrong");
        compared = column.value("compared");
        compared.setText(texts.text("compared.coverage"));
        compared.setToolTipText(texts.text("compared.coverage.hint"));
        missing = column.value("missing");
        missing.setIcon(new PixelMarkIcon(PixelMark.MISSING));
        extra = column.value("extra");
        extra.setIcon(new PixelMarkIcon(PixelMark.EXTRA));
        worst = column.value("worst");
        other = column.value("other");
        tried = column.value("tried");
        apart = column.value("apart");
    }

    private void addAbout() {
        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        LineLabState state = model.state();
        var readings = new LineReadings(state, texts);
        method.show(state.choice().method());
        comparison.show(state.choice().comparison());
        a.refresh();
        b.refresh();
        pixel.setText(readings.pixel());
        boolean covered = state.drawing().coverage().isPresent();
        column.showRow(coverage, covered);
        column.showRow(compared, covered);
        coverage.setText(readings.coverage());
        decision.setText(readings.decision());
        decided.setText(readings.decided());
        missing.setText(readings.missing());
        extra.setText(readings.extra());
        worst.setText(readings.worst());
        boolean program = state.drawings().tried().isPresent();
        column.showRow(other, state.other().isPresent() && !program);
        column.showRow(tried, state.other().isPresent() && program);
        other.setText(readings.other());
        tried.setText(readings.other());
        column.showRow(apart, state.drawings().apart().isPresent());
        apart.setText(readings.apart());
        apart.setToolTipText(texts.text(program ? "apart.hint.tried" : "apart.hint"));
        explain(state);
    }

    private void explain(LineLabState state) {
        Method<LineRasterizer> chosen = model.method(state.choice().method());
        about.show(said.texts(), chosen.name(), decisionFormula(chosen), refusal(state));
    }

    private String decisionFormula(Method<LineRasterizer> chosen) {
        return chosen.implementation() instanceof SteppedLine stepped
                ? said.decision(chosen, stepped.decisionFormula())
                : "";
    }

    /** Why the method refused the segment. */
    private String refusal(LineLabState state) {
        LineTrace trace = state.drawing().trace();
        return trace.ending() == LineTrace.TraceEnding.REFUSED
                ? OwnWords.reason(state.drawing().method(), trace.message(), texts.language())
                : "";
    }
}
