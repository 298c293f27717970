package rasterlab.app.spline;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.FormulaView;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.widget.NumberSlider;
import rasterlab.app.canvas.widget.WrappedText;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.language.Texts;
import rasterlab.app.spline.curve.BlendingChart;
import rasterlab.app.spline.curve.PlanRows;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.CurveTracer;
import rasterlab.engine.spline.curve.SteppedCurve;
import rasterlab.engine.study.Method;

/** The curve lab's choosers, live numbers, matrices and the explanation of the chosen method. */
final class CurveInspector {
    private static final int FIRST_STEPS = 12;

    private final CurveLabModel model;
    private final Texts texts;
    private final TopicTexts said;
    private final Inspector column;
    private final InspectorParts parts;
    private NameChooser form;
    private NameChooser joining;
    private MethodChooser method;
    private MethodChooser comparison;
    private NameChooser sampling;
    private NumberSlider flatness;
    private NumberSlider steps;
    private NumberSlider t;
    private JCheckBox construction;
    private JCheckBox comb;
    private JCheckBox hull;
    private PlanRows plan;
    private JLabel segments;
    private JLabel error;
    private JLabel other;
    private JLabel decision;
    private JLabel joints;
    private JLabel span;
    private JLabel point;
    private JLabel derivative;
    private JLabel curvature;
    private WrappedText noMatrix;
    private final FormulaView formulas = new FormulaView("formulas");
    private BlendingChart blending;
    private AboutText about;

    CurveInspector(CurveLabModel model, Texts texts, Consumer<SplineMode> onMode) {
        this.model = model;
        this.texts = texts;
        said = TopicTexts.of("curve", texts.language());
        column = new Inspector(texts);
        parts = new InspectorParts(column, texts);
        parts.mode(SplineMode.CURVE, onMode);
    }

    /**
     * The sections that the constructor leaves out, in the column's order, as {@link
     * LabPanel#parts}.
     */
    List<Runnable> sections() {
        return List.of(
                this::addMethods,
                this::addChoices,
                this::addReadings,
                () -> plan = new PlanRows(column, texts, model::plan),
                this::addAt,
                this::addMatricesAndAbout);
    }

    private void addMethods() {
        List<String> names = model.methods().stream().map(Method::name).toList();
        form = form();
        joining = joining();
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
    }

    private void addChoices() {
        sampling = parts.names("sampling", List.of("flat", "equal"), this::sample);
        flatness = flatness();
        steps = steps();
        t = parts.slider("t", 0, 1, false, 500, model::goToT);
        construction =
                parts.box("construction", on -> model.overlay(overlays().withConstruction(on)));
        comb = parts.box("comb", on -> model.overlay(overlays().withComb(on)));
        hull = parts.box("hull", on -> model.overlay(overlays().withHull(on)));
        addBoxes();
    }

    private void addReadings() {
        column.heading("heading.polyline");
        segments = column.value("segments");
        error = column.value("error");
        other = column.value("other");
        decision = column.value("decision");
        joints = column.value("joints");
    }

    private void addAt() {
        column.heading("heading.at");
        span = column.value("span");
        point = column.value("point");
        derivative = column.value("derivative");
        curvature = column.value("curvature");

        noMatrix = new WrappedText("noMatrix");
        noMatrix.show(texts.text("noMatrix"));
        blending = new BlendingChart(texts.text("blending"));
    }

    private NameChooser form() {
        return parts.names(
                "form",
                Stream.of(CurveForm.values()).map(CurveForm::code).toList(),
                code -> model.chooseForm(CurveForm.named(code)));
    }

    private NameChooser joining() {
        return parts.names(
                "joining",
                Stream.of(CurveJoining.values()).map(Enum::name).toList(),
                name -> model.chooseJoining(CurveJoining.valueOf(name)));
    }

    private NumberSlider flatness() {
        return parts.slider(
                "flatness",
                Sampling.FINEST,
                Sampling.COARSEST,
                true,
                100,
                pixels -> model.sample(Sampling.flat(pixels)));
    }

    private NumberSlider steps() {
        return parts.slider(
                "steps",
                1,
                Sampling.MOST_STEPS,
                false,
                Sampling.MOST_STEPS - 1,
                count -> model.sample(Sampling.equal((int) Math.round(count))));
    }

    private void addMatricesAndAbout() {
        about = new AboutText("about", texts.language());
        column.heading("heading.matrix");
        column.wide(noMatrix);
        column.wide(formulas);
        column.wide(blending);
        column.heading("heading.about");
        column.wide(about);
    }

    private void addBoxes() {
        var row = new JPanel(new FlowRows(8));
        FlowRows.keepWrapped(row);
        for (JCheckBox box : List.of(construction, comb, hull)) row.add(box);
        column.wide(row);
    }

    private CurveOverlays overlays() {
        return model.state().choice().overlays();
    }

    private void sample(String how) {
        boolean flat = how.equals("flat");
        if (flat == model.state().choice().sampling().isFlat()) return;
        model.sample(
                flat ? Sampling.flat(CurveLabModel.FIRST_FLATNESS) : Sampling.equal(FIRST_STEPS));
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        CurveLabState state = model.state();
        var readings = new CurveReadings(state, texts);
        showChoice(state.choice(), readings);
        segments.setText(readings.segments());
        error.setText(readings.error());
        column.showRow(other, state.drawings().other().isPresent());
        other.setText(readings.other());
        decision.setText(readings.decision());
        column.showRow(joints, !state.drawings().joints().isEmpty());
        joints.setText(readings.joints());
        plan.show(state.choice().planning(), state.drawings().plan());
        span.setText(readings.span());
        point.setText(readings.point());
        derivative.setText(readings.derivative());
        curvature.setText(readings.curvature());
        boolean known = state.at().form().isPresent();
        noMatrix.setVisible(!known);
        formulas.setVisible(known);
        blending.setVisible(known);
        state.at()
                .form()
                .ifPresent(
                        shown -> {
                            formulas.show(
                                    new CurveFormulas(shown, state.at().place(), texts.locale())
                                            .lines());
                            blending.show(shown);
                        });
        explain(state);
    }

    private void showChoice(CurveChoice choice, CurveReadings readings) {
        form.show(choice.form().code());
        joining.show(choice.joining().name());
        column.showRow(joining, choice.form() == CurveForm.PIECES);
        method.show(choice.method());
        comparison.show(choice.comparison());
        boolean flat = choice.sampling().isFlat();
        sampling.show(flat ? "flat" : "equal");
        column.showRow(flatness, flat);
        column.showRow(steps, !flat);
        if (flat) flatness.show(choice.sampling().flatness(), readings.flatness());
        else steps.show(choice.sampling().steps(), String.valueOf(choice.sampling().steps()));
        t.show(model.state().t(), readings.t());
        construction.setSelected(choice.overlays().construction());
        comb.setSelected(choice.overlays().comb());
        hull.setSelected(choice.overlays().hull());
    }

    private void explain(CurveLabState state) {
        Method<CurveTracer> chosen = model.method(state.choice().method());
        CurveDrawing drawing = state.drawing();
        boolean refused =
                drawing.method().equals(chosen.name())
                        && drawing.ending() == CurveDrawing.CurveEnding.REFUSED;
        about.show(
                said.texts(),
                chosen.name(),
                decisionFormula(chosen),
                refused
                        ? OwnWords.reason(drawing.method(), drawing.message(), texts.language())
                        : "");
    }

    private String decisionFormula(Method<CurveTracer> chosen) {
        return chosen.implementation() instanceof SteppedCurve stepped
                ? said.decision(chosen, stepped.decisionFormula())
                : "";
    }
}
