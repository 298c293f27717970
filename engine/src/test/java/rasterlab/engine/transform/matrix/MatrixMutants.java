package rasterlab.engine.transform.matrix;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Mutants;

/** Matrices written down with one mistake. */
final class MatrixMutants implements Mutants<MatrixFormula> {
    private static final MatrixFormula RIGHT = new NamedFormula();

    /** Matrices without parameters by their names. */
    private final Map<String, double[][]> kept = new HashMap<>();

    private static final MatrixFormula PRINTED = new AppendixFormula();

    @Override
    public List<Mutant<MatrixFormula>> all() {
        return List.of(
                new Mutant<>("about y clockwise", "about-y", MatrixMutants::aboutYClockwise),
                new Mutant<>("SCALE3DY flattens x", "scale-y", printed("SCALE3DY")),
                new Mutant<>("SCALE3DZ flattens x and y", "scale-z", printed("SCALE3DZ")),
                new Mutant<>("SCALE3D by s for 1/s", "scale-all", MatrixMutants::scaledByS),
                new Mutant<>("shift in the last column", "shift", MatrixMutants::transposedShift),
                new Mutant<>("DIMETRIC's angles exchanged", "dimetric", printed("DIMETRIC")),
                new Mutant<>("ROTAXIS moves its axis", "axis", printed("ROTAXIS")),
                new Mutant<>("ROTAXIS divides by d = 0", "axis-along-z", MatrixMutants::byZero),
                new Mutant<>("angles in float", "huge-angle", MatrixMutants::anglesInFloat),
                new Mutant<>(
                        "a matrix without parameters is handed out, not copied",
                        "dimetric",
                        (name, parameters) ->
                                parameters.length == 0
                                        ? kept.computeIfAbsent(name, RIGHT::rows)
                                        : RIGHT.rows(name, parameters)));
    }

    /** One matrix as the appendix of the course's text has it. */
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
            rows[0][0] = 0.0 / 0.0;
        return rows;
    }

    private static double[][] anglesInFloat(String name, double... parameters) {
        double[] changed = parameters.clone();
        if (name.startsWith("ROT"))
            changed[changed.length - 1] = (float) changed[changed.length - 1];
        return RIGHT.rows(name, changed);
    }
}
