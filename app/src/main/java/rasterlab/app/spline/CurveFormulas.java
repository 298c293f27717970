package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.canvas.widget.Formula.FormulaWords;
import rasterlab.app.canvas.widget.Formula.Matrix;
import rasterlab.engine.spline.curve.CurvePlace;
import rasterlab.engine.spline.curve.SpanForm;

/** The matrix form of a span with its numbers, in the textbook's layout. */
final class CurveFormulas {
    private final SpanForm form;
    private final CurvePlace place;
    private final Locale locale;

    CurveFormulas(SpanForm form, CurvePlace place, Locale locale) {
        this.form = form;
        this.place = place;
        this.locale = locale;
    }

    List<Formula> lines() {
        String divided = form.divisor() == 1 ? "" : "1/" + form.divisor() + " ·";
        return List.of(
                Formula.of(new FormulaWords("P(u) = T·M·G,  T ="), row(form.powers(), 3)),
                Formula.of(
                        new FormulaWords("M ="),
                        new FormulaWords(divided),
                        matrix(form.matrix()),
                        new FormulaWords("G ="),
                        matrix(form.geometry())),
                Formula.of(
                        new FormulaWords("C = M·G ="),
                        matrix(form.coefficients()),
                        new FormulaWords("T·C ="),
                        row(new double[] {place.x(), place.y()}, 2)),
                Formula.of(new FormulaWords("T·M ="), row(form.weights(), 3)));
    }

    private Matrix row(double[] numbers, int decimals) {
        return Matrix.row(
                DoubleStream.of(numbers).mapToObj(each -> Shown.number(each, decimals, locale)));
    }

    private Matrix matrix(double[][] rows) {
        var cells = new ArrayList<List<String>>();
        for (double[] row : rows)
            cells.add(Arrays.stream(row).mapToObj(each -> Shown.number(each, 1, locale)).toList());
        return new Matrix(cells);
    }
}
