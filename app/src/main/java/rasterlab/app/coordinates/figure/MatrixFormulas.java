package rasterlab.app.coordinates.figure;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.NamedMatrices;
import rasterlab.engine.transform.matrix.NamedMatrix;

/** Matrices with live numbers in the textbook's layout. */
public final class MatrixFormulas {
    private static final int DECIMALS = 4;

    /** Smaller ones are written with a power of ten. */
    private static final double LEAST_DECIMAL = 1e-4;

    private MatrixFormulas() {}

    /** The formula {@code said = [matrix]}. */
    public static Formula named(String said, double[] cells, Locale locale) {
        return Formula.of(new Formula.FormulaWords(said), matrix(cells, locale));
    }

    public static Formula.Matrix matrix(double[] cells, Locale locale) {
        int size = cells.length == 9 ? 3 : 4;
        var rows = new ArrayList<List<String>>();
        for (int i = 0; i < cells.length; i += size) {
            var row = new ArrayList<String>();
            for (int j = i; j < i + size; j++) row.add(cell(cells[j], locale));
            rows.add(row);
        }
        return new Formula.Matrix(rows);
    }

    /**
     * The number with three significant digits at least, so that 1/r with r = 700 is not 0.0014.
     */
    static String cell(double value, Locale locale) {
        double size = Math.abs(value);
        boolean small = size >= LEAST_DECIMAL && size < 0.01;
        int decimals = small ? 2 - (int) Math.floor(Math.log10(size)) : DECIMALS;
        return Shown.number(value, decimals, locale);
    }

    /** {@code [x y z 1]} or any other row of numbers. */
    public static Formula.Matrix row(Locale locale, double... numbers) {
        return Formula.Matrix.row(
                DoubleStream.of(numbers).mapToObj(each -> Shown.number(each, 3, locale)));
    }

    /** The separator between numbers: a semicolon where they have a decimal comma. */
    public static String apart(Locale locale) {
        return Shown.apart(locale);
    }

    /** Name and numbers as the course writes them: {@code ROT3DX(−90°)}. */
    public static String callText(MatrixCall call, Locale locale) {
        NamedMatrix matrix = NamedMatrices.named(call.name());
        if (matrix.parameters().isEmpty()) return call.name();
        return call.numbers().stream()
                .map(number -> Shown.number(number, 5, locale))
                .collect(Collectors.joining(apart(locale), call.name() + "(", ")"));
    }
}
