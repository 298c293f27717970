package rasterlab.app.spline;

import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JLabel;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.contract.SplineEnds;
import rasterlab.contract.SplineFunction;
import rasterlab.engine.spline.function.SteppedSpline;
import rasterlab.engine.study.Method;

/** The function lab's choosers, live numbers, coefficients and the chosen method's explanation. */
final class FunctionInspector {
    private final FunctionLabModel model;
    private final Texts texts;
    private final TopicTexts said;
    private final Inspector column;
    private final MethodChooser method;
    private final MethodChooser comparison;
    private final NameChooser ends;
    private final SlopeFields slopes;
    private final NumberSlider share;
    private final JLabel unknowns;
    private final JLabel phase;
    private final JLabel decision;
    private final JLabel overshoot;
    private final JLabel other;
    private final JLabel error;
    private final JLabel piece;
    private final JLabel value;
    private final JLabel slope;
    private final JLabel second;
    private final FormulaView coefficients = new FormulaView("coefficients");
    private final AboutText about;

    FunctionInspector(FunctionLabModel model, Texts texts, Consumer<SplineMode> onMode) {
        this.model = model;
        this.texts = texts;
        said = TopicTexts.of("spline-function", texts.language());
        column = new Inspector(texts);
        var parts = new InspectorParts(column, texts);
        parts.mode(SplineMode.FUNCTION, onMode);
        List<String> names = model.methods().stream().map(Method::name).toList();
        Texts shared = Texts.of("canvas", texts.language());
        method =
                new MethodChooser("method", "", names, SplineColors.OWN, model::chooseMethod)
                        .withOwn(shared);
        column.row("method", method);
        comparison =
                new MethodChooser(
                                "comparison",
                                texts.text("none"),
                                names,
                                SplineColors.OWN,
                                model::compareWith)
                        .withOwn(shared);
        column.row("comparison", comparison);
        ends =
                parts.names(
                        "ends",
                        Stream.of(SplineEnds.Kind.values()).map(FunctionCommand::code).toList(),
                        this::chooseEnds);
        slopes = new SlopeFields(model, texts);
        column.row("slopes", slopes);
        share = parts.slider("share", 0, 1, false, 500, model::readAt);

        column.heading("heading.overshoot");
        overshoot = column.value("overshoot");
        other = column.value("other.overshoot");
        error = column.value("error");

        column.heading("heading.step");
        unknowns = column.value("unknowns");
        phase = column.value("phase");
        decision = column.value("decision");

        column.heading("heading.read");
        piece = column.value("piece");
        value = column.value("value");
        slope = column.value("slope");
        second = column.value("second");

        column.heading("heading.coefficients");
        column.wide(coefficients);
        column.heading("heading.about");
        about = new AboutText("about", texts.language());
        column.wide(about);
    }

    private void chooseEnds(String code) {
        var kind = SplineEnds.Kind.valueOf(code.toUpperCase(Locale.ROOT).replace('-', '_'));
        if (kind != model.state().choice().ends().kind())
            model.chooseEnds(new SplineEnds(kind, 0, 0));
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        FunctionLabState state = model.state();
        FunctionChoice choice = state.choice();
        var readings = new FunctionReadings(state, texts);
        method.show(choice.method());
        comparison.show(choice.comparison());
        ends.show(FunctionCommand.code(choice.ends().kind()));
        column.showRow(slopes, choice.ends().kind() == SplineEnds.Kind.SLOPES);
        slopes.show(choice.ends());
        share.show(state.share(), readings.at());
        unknowns.setText(readings.unknowns());
        phase.setText(readings.phase());
        decision.setText(readings.decision());
        column.nameRow(decision, readings.decides());
        overshoot.setText(readings.overshoot());
        column.showRow(other, state.drawings().other().isPresent());
        other.setText(readings.other());
        error.setText(readings.error());
        piece.setText(readings.piece());
        value.setText(readings.value());
        slope.setText(readings.slope());
        second.setText(readings.second());
        coefficients.show(readings.coefficients());
        explain(state);
    }

    private void explain(FunctionLabState state) {
        Method<SplineFunction> chosen = model.method(state.choice().method());
        FunctionDrawing drawing = state.drawing();
        boolean refused =
                drawing.method().equals(chosen.name())
                        && drawing.ending() == FunctionDrawing.FunctionEnding.REFUSED;
        about.show(
                said.texts(),
                chosen.name(),
                decisionFormula(chosen),
                refused
                        ? OwnWords.reason(drawing.method(), drawing.message(), texts.language())
                        : "");
    }

    private String decisionFormula(Method<SplineFunction> chosen) {
        return chosen.implementation() instanceof SteppedSpline stepped
                ? said.decision(chosen, stepped.decisionFormula())
                : "";
    }
}
