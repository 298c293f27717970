package rasterlab.app.coordinates.turn;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.lab.Inspector;
import rasterlab.app.canvas.method.AboutText;
import rasterlab.app.canvas.method.MethodChooser;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.NumberField;
import rasterlab.app.card.TopicTexts;
import rasterlab.app.coordinates.figure.MatrixFormulas;
import rasterlab.app.coordinates.figure.NamedControls;
import rasterlab.app.coordinates.figure.NumberTable;
import rasterlab.app.coordinates.figure.SliderField;
import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.app.language.Texts;
import rasterlab.contract.PlaneRotation;

/** The lab's choosers, the present step and how far each method is off. */
final class TurnInspector {
    private static final SliderField.Range DEGREES =
            new SliderField.Range(-1e18, 1e18, -180, 180, 0.5, false);
    private static final SliderField.Range TIMES =
            new SliderField.Range(1, PlaneRotation.MOST_TIMES, 1, 1e6, 1, true);
    private static final double FARTHEST = 0x1p1000;

    private final TurnLabModel model;
    private final Texts texts;
    private final Texts explanations;
    private final Inspector column;
    private final MethodChooser method;
    private final SliderField degrees;
    private final SliderField times;
    private final NumberField x;
    private final NumberField y;
    private final JLabel turn;
    private final JLabel formula;
    private final JLabel value;
    private final JLabel at;
    private final JLabel operations;
    private final NumberTable table;
    private final AboutText about;

    /**
     * @param mode adds the row that leads to the other labs
     */
    TurnInspector(TurnLabModel model, Texts texts, Consumer<Inspector> mode) {
        this.model = model;
        this.texts = texts;
        explanations = TopicTexts.of("rotate", texts.language()).texts();
        column = new Inspector(texts);
        var parts = new NamedControls(column, texts);
        mode.accept(column);
        method =
                parts.method(model.methods(), model::chooseMethod)
                        .withOwn(Texts.of("canvas", texts.language()));
        degrees = parts.number("degrees", DEGREES, model::turnBy);
        times = parts.number("times", TIMES, model::turnTimes);
        times.takeOnlyWhole();
        x = field("x");
        y = field("y");
        var point = new JPanel(new MigLayout("insets 0, gap 6", "[grow,fill,0::][grow,fill,0::]"));
        point.add(x, "wmin 0");
        point.add(y, "wmin 0");
        column.row("point", point);

        column.heading("heading.step");
        turn = column.value("turn");
        formula = column.value("formula");
        value = column.value("value");
        at = column.value("at");
        operations = column.value("operations");

        column.heading("heading.drift");
        table = parts.table("heading.drift");

        about = parts.about();
    }

    private NumberField field(String axis) {
        return new NumberField(
                "point." + axis,
                texts.text("coordinate", axis),
                -FARTHEST,
                FARTHEST,
                0.5,
                texts.locale(),
                entered ->
                        model.movePoint(
                                axis.equals("x") ? entered : model.choice().x(),
                                axis.equals("y") ? entered : model.choice().y()));
    }

    Inspector column() {
        return column;
    }

    /** Shows the model's present state. */
    void refresh() {
        TurnChoice choice = model.choice();
        method.show(choice.method());
        degrees.show(choice.degrees());
        times.show(choice.times());
        x.show(choice.x());
        y.show(choice.y());
        showStep();
        operations.setText(operations(model.operations()));
        table.show(headings(), rows(), own());
        about.show(explanations, model.method().name(), "", refusal(model, texts));
    }

    /** Why the method does not turn the point; "" where it does, or that is not known yet. */
    static String refusal(TurnLabModel model, Texts texts) {
        TurnScene scene = model.scene();
        boolean known = scene.known() && scene.choice().equals(model.choice());
        if (!known || !scene.drift().refused()) return "";
        TurnScene.Drift drift = scene.drift();
        return OwnWords.refusal(drift.method(), drift.refusal(), texts.language())
                .orElseGet(() -> texts.text("refused.long"));
    }

    private void showStep() {
        List<TurnScene.TurnStep> steps = model.scene().steps();
        boolean any = model.step() > 0 && model.step() <= steps.size();
        TurnScene.TurnStep step = any ? steps.get(model.step() - 1) : null;
        Locale locale = texts.locale();
        turn.setText(any ? String.valueOf(step.turn()) : "—");
        boolean shown = any && !step.formula().isEmpty();
        formula.setText(shown ? step.formula() : "—");
        value.setText(shown ? Shown.number(step.value(), 6, locale) : "—");
        at.setText(any ? Shown.point(step.at().x(), step.at().y(), locale) : "—");
    }

    private String operations(Map<String, Long> counts) {
        if (counts.isEmpty()) return "—";
        return new TreeMap<>(counts)
                .entrySet().stream()
                        .map(
                                each ->
                                        each.getValue()
                                                + texts.textOr(
                                                        "count." + each.getKey(),
                                                        " " + each.getKey()))
                        .collect(Collectors.joining(", "));
    }

    private List<String> headings() {
        return List.of(
                texts.text("drift.method"), texts.text("drift.error"), texts.text("drift.end"));
    }

    private int own() {
        return model.scene().drifts().stream()
                .map(TurnScene.Drift::method)
                .toList()
                .indexOf(model.choice().method());
    }

    private List<List<String>> rows() {
        var rows = new ArrayList<List<String>>();
        for (TurnScene.Drift each : model.scene().drifts())
            rows.add(
                    List.of(
                            OwnWords.called(each.method(), texts.language()),
                            error(each),
                            each.refused() ? "—" : place(each.end())));
        return rows;
    }

    /** Short enough for the column. */
    private String place(StagePoint at) {
        Locale locale = texts.locale();
        return "("
                + Shown.number(at.x(), 2, locale)
                + MatrixFormulas.apart(locale)
                + Shown.number(at.y(), 2, locale)
                + ")";
    }

    private String error(TurnScene.Drift drift) {
        if (drift.refused())
            return OwnWords.without(drift.method(), texts.text("drift.refused"), texts.language());
        return drift.right()
                ? texts.text("drift.right")
                : Shown.number(drift.error(), 3, texts.locale());
    }
}
