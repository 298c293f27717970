package rasterlab.app.coordinates.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.joml.Vector4d;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.MatrixFormulas;
import rasterlab.app.language.Texts;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.chain.TransformTopic;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.view.ViewTask;
import rasterlab.engine.transform.view.ViewTopic;

/** The state of the lab in words, numbers and formulas of one language. */
final class ViewReadings {
    private static final int DECIMALS = 2;

    private final ViewLabModel model;
    private final ViewScene scene;
    private final Texts texts;
    private final Locale locale;

    ViewReadings(ViewLabModel model, Texts texts) {
        this.model = model;
        this.texts = texts;
        scene = model.scene();
        locale = texts.locale();
    }

    private String number(double value) {
        return Shown.number(value, DECIMALS, locale);
    }

    String stage() {
        return texts.text("space." + model.stage().space().code());
    }

    String family() {
        return texts.text("family." + model.choice().kind().family());
    }

    String frame() {
        return texts.text(scene.rightHanded(model.step()) ? "frame.right" : "frame.left");
    }

    String gamma() {
        return scene.depth()
                .map(
                        depth ->
                                texts.text(
                                        depth.nearest() < 2 * depth.half()
                                                ? "gamma.runaway"
                                                : "gamma.value",
                                        number(depth.gamma()),
                                        number(depth.nearest()),
                                        number(depth.half())))
                .orElse(texts.text("gamma.none"));
    }

    /** Multiplications and additions for one point, as one matrix and taken apart. */
    String operations() {
        var topic = new ViewTopic();
        var look = new ViewTask(30, 70, 400, new double[] {1, 2, 3});
        var counts = new ArrayList<Object>();
        for (var method : topic.methods()) {
            var counted = topic.operations(method.implementation(), look);
            counts.add(counted.get("multiplications"));
            counts.add(counted.get("additions"));
        }
        return texts.text("operations.value", counts.toArray());
    }

    String fit() {
        PictureFit fit = ViewStages.fit(model.choice());
        return texts.text("fit.value", number(fit.pixelsPerUnit()), fit.centerX(), fit.centerY());
    }

    String error() {
        return scene.deviation()
                .map(
                        found ->
                                new TransformTopic().correct(found)
                                        ? texts.text("error.none")
                                        : Shown.number(found.worst(), 2, locale))
                .orElse("—");
    }

    /** The stage's matrices one by one, their product, and the chosen vertex on its way. */
    List<Formula> formulas() {
        var lines = new ArrayList<Formula>();
        List<MatrixCall> calls = model.stage().calls();
        if (calls.isEmpty()) {
            lines.add(Formula.of(new Formula.FormulaWords(texts.text("matrix.none"))));
            return lines;
        }
        for (MatrixCall call : calls) lines.add(Formula.of(words(call)));
        lines.add(
                MatrixFormulas.named(
                        calls.size() > 1 ? "M =" : "=",
                        Chains.cells(Chains.product(Chains.cells(calls))),
                        locale));
        worked(lines);
        return lines;
    }

    private Formula.FormulaWords words(MatrixCall call) {
        return new Formula.FormulaWords(MatrixFormulas.callText(call, locale));
    }

    private void worked(List<Formula> lines) {
        int vertex = model.choice().vertex() - 1;
        int stage = model.step();
        var before = scene.image(stage - 1);
        var after = scene.image(stage);
        if (before.isEmpty() || after.isEmpty()) return;
        var point = new double[4];
        for (int axis = 0; axis < 3; axis++) point[axis] = before.get().coordinate(vertex, axis);
        point[3] = 1;
        var output =
                Chains.product(Chains.cells(model.stage().calls()))
                        .transform(new Vector4d(point[0], point[1], point[2], 1));
        lines.add(Formula.of(MatrixFormulas.row(locale, point), new Formula.FormulaWords("· M =")));
        lines.add(
                Formula.of(
                        new Formula.FormulaWords("="),
                        MatrixFormulas.row(locale, output.x, output.y, output.z, output.w),
                        new Formula.FormulaWords(output.w == 1 ? "" : "÷ H →")));
        if (output.w != 1) lines.add(divided(after.get(), vertex));
    }

    private Formula divided(ViewScene.StagePoints image, int vertex) {
        if (!Double.isFinite(image.coordinate(vertex, 0)))
            return Formula.of(new Formula.FormulaWords("→ " + texts.text("matrix.infinite")));
        return Formula.of(
                new Formula.FormulaWords("→"),
                MatrixFormulas.row(
                        locale,
                        image.coordinate(vertex, 0),
                        image.coordinate(vertex, 1),
                        image.coordinate(vertex, 2),
                        1));
    }

    List<String> headings() {
        return model.stage().space().deep()
                ? List.of("№", "x", "y", "z")
                : List.of("№", "X", "Y", "Z", "H");
    }

    List<List<String>> rows() {
        var rows = new ArrayList<List<String>>();
        var image = scene.image(model.step());
        if (image.isEmpty()) return rows;
        for (int v = 0; v < ViewScene.HOUSE.size(); v++) {
            var row = new ArrayList<String>();
            row.add(String.valueOf(v + 1));
            for (int axis = 0; axis < 3; axis++) {
                double coordinate = image.get().coordinate(v, axis);
                row.add(Double.isFinite(coordinate) ? number(coordinate) : "—");
            }
            if (!model.stage().space().deep())
                row.add(Shown.number(image.get().h().get(v), 4, locale));
            rows.add(row);
        }
        return rows;
    }
}
