package rasterlab.engine.transform.matrix;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Mutant;

/** Matrices written down with one mistake. */
final class MatrixMutants {
    private static final MatrixFormula RIGHT = new NamedFormula();
    private static final MatrixFormula PRINTED = new AppendixFormula();

    private MatrixMutants() {}

    static List<Mutant<MatrixFormula>> all() {
        return List.of(
                new Mutant<>("about-y-clockwise", "about-y", MatrixMutants::aboutYClockwise),
                new Mutant<>("scale-y-flattens-x", "scale-y", printed("SCALE3DY")),
                new Mutant<>("scale-z-flattens-x-y", "scale-z", printed("SCALE3DZ")),
                new Mutant<>("scaled-by-s", "scale-all", MatrixMutants::scaledByS),
                new Mutant<>("shift-in-last-column", "shift", MatrixMutants::transposedShift),
                new Mutant<>("dimetric-angles-swapped", "dimetric", printed("DIMETRIC")),
                new Mutant<>("axis-moves", "axis", printed("ROTAXIS")),
                new Mutant<>("axis-divides-by-0", "axis-along-z", MatrixMutants::byZero),
                new Mutant<>("angles-in-float", "huge-angle", MatrixMutants::anglesInFloat),
                new Mutant<>("array-shared", "dimetric", kept()));
    }

    /** Matrices without parameters are computed once. */
    private static MatrixFormula kept() {
        var kept = new HashMap<String, double[][]>();
        return (name, parameters) ->
                parameters.length == 0
                        ? kept.computeIfAbsent(name, RIGHT::rows)
                        : RIGHT.rows(name, parameters);
    }

    /** One matrix as the appendix of Ponomarev's book has it. */
    private static MatrixFormula printed(String wrong) {
        return (name, parameters) -> (name.equals(wrong) ? PRINTED : RIGHT).rows(name, parameters);
    }

    private static double[][] aboutYClockwise(String name, double... parameters) {
        return name.equals("ROT3DY")
                ? RIGHT.rows(name, -parameters[0])
                : RIGHT.rows(name, parameters);
    }

    private static double[][] scaledByS(String name, double... parameters) {
        double[][] rows = RIGHT.rows(name, parameters);
        if (name.equals("SCALE3D")) {
            for (int i = 0; i < 3; i++) rows[i][i] = parameters[0];
            rows[3][3] = 1;
        }
        return rows;
    }

    private static double[][] transposedShift(String name, double... parameters) {
        double[][] rows = RIGHT.rows(name, parameters);
        if (name.startsWith("TRANSL"))
            for (int i = 0; i < rows.length - 1; i++) {
                rows[i][rows.length - 1] = rows[rows.length - 1][i];
                rows[rows.length - 1][i] = 0;
            }
        return rows;
    }

    private static double[][] byZero(String name, double... parameters) {
        double[][] rows = RIGHT.rows(name, parameters);
        if (name.equals("ROTAXIS") && parameters[3] == 0 && parameters[4] == 0)
            for (double[] row : rows) Arrays.fill(row, 0, 3, 0.0 / 0.0);
        return rows;
    }

    private static double[][] anglesInFloat(String name, double... parameters) {
        double[] changed = parameters.clone();
        if (name.startsWith("ROT"))
            changed[changed.length - 1] = (float) changed[changed.length - 1];
        return RIGHT.rows(name, changed);
    }
}
