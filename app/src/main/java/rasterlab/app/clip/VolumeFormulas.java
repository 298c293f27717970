package rasterlab.app.clip;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.canvas.widget.Formula.FormulaWords;
import rasterlab.app.canvas.widget.Formula.Matrix;
import rasterlab.app.language.Texts;

/**
 * The two normalisations as matrices in the textbook's layout, and a segment's ends through them.
 */
final class VolumeFormulas {
    private static final int DECIMALS = 3;

    private final VolumeNumbers numbers;
    private final Texts texts;

    VolumeFormulas(VolumeNumbers numbers, Texts texts) {
        this.numbers = numbers;
        this.texts = texts;
    }

    List<Formula> lines() {
        var lines = new ArrayList<Formula>();
        lines.add(title("matrices.normalize"));
        lines.add(Formula.of(matrix(numbers.normalize())));
        lines.add(title("matrices.canonical"));
        lines.add(Formula.of(matrix(numbers.canonical())));
        lines.add(title("matrices.ends"));
        for (int i = 0; i < numbers.ends().size(); i++) lines.add(end(i));
        return lines;
    }

    private Formula title(String key) {
        return Formula.of(new FormulaWords(texts.text(key)));
    }

    private Formula end(int row) {
        String[] stages = {
            texts.text("matrices.eye"), texts.text("matrices.normalised"), "· Mₚ", "÷ H"
        };
        String end = row < VolumeNumbers.STAGES ? "A1 " : "B1 ";
        return Formula.of(
                new FormulaWords(end + stages[row % VolumeNumbers.STAGES] + " ="),
                new Matrix(List.of(cells(numbers.ends().get(row)))));
    }

    private Matrix matrix(double[] rows) {
        return new Matrix(
                IntStream.range(0, 4)
                        .mapToObj(row -> cells(Arrays.copyOfRange(rows, 4 * row, 4 * row + 4)))
                        .toList());
    }

    private List<String> cells(double[] row) {
        return DoubleStream.of(row)
                .mapToObj(each -> Shown.number(each, DECIMALS, texts.locale()))
                .toList();
    }
}
