package rasterlab.engine.transform.matrix;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.contract.MatrixFormula;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.SharedAnswer;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * Writing down a named matrix.
 *
 * <p>The error of a cell is its difference over the largest cell of its row, and over the largest
 * coordinate of a point among the parameters where that is larger, since a shift is made of it. Up
 * to 32·2⁻⁵³ counts as exact: a cell is made of a few rounded operations.
 */
public final class MatrixTopic implements Topic<MatrixFormula, MatrixCall, double[][]> {
    private static final double CORRECT = 32 * 0x1p-53;
    private static final double USABLE = 1e-6;

    @Override
    public String name() {
        return "matrix";
    }

    @Override
    public String lab() {
        return "coordinates";
    }

    @Override
    public Class<MatrixFormula> contract() {
        return MatrixFormula.class;
    }

    @Override
    public List<Method<MatrixFormula>> methods() {
        return MatrixMethods.all();
    }

    @Override
    public List<Hazard<MatrixCall>> hazards() {
        return MatrixHazards.all();
    }

    @Override
    public List<Workload<MatrixCall>> workloads() {
        return MatrixWorkloads.all();
    }

    @Override
    public List<Mutant<MatrixFormula>> mutants() {
        return MatrixMutants.all();
    }

    @Override
    public Map<String, String> vocabulary() {
        var words = new LinkedHashMap<String, String>();
        for (NamedMatrix matrix : NamedMatrices.all())
            words.put(matrix.usage(), matrix.meaning() + "; inverse: " + matrix.inverse().text());
        return words;
    }

    @Override
    public double[][] run(MatrixFormula method, MatrixCall call, int limit) {
        double[] given = call.parameters();
        double[][] rows = method.rows(call.name(), given);
        double[][] again = method.rows(call.name(), call.parameters());
        SharedAnswer.requireNew(rows, given, again);
        for (int i = 0; rows != null && again != null && i < rows.length; i++)
            SharedAnswer.requireNew(rows[i], given, i < again.length ? again[i] : null);
        return rows;
    }

    @Override
    public long spend(MatrixFormula method, MatrixCall call) {
        return method.rows(call.name(), call.parameters()).length > 0 ? 1 : 0;
    }

    @Override
    public double[][] exact(MatrixCall call, int limit) {
        try {
            return ExactMatrices.of(call.name(), call.parameters()).toDoubles();
        } catch (ArithmeticException none) {
            // where there is no matrix, the formula tells which parameter is why
            NamedMatrices.named(call.name()).rows(call.parameters());
            throw none;
        }
    }

    @Override
    public Deviation compare(MatrixCall call, double[][] exact, double[][] actual) {
        long of = (long) exact.length * exact.length;
        String shape = shape(exact.length, actual);
        if (!shape.isEmpty()) return new Deviation(Double.POSITIVE_INFINITY, 0, 0, of, shape);
        double worst = 0;
        String first = "";
        for (int i = 0; i < exact.length; i++) {
            double scale = scale(call, exact, i);
            for (int j = 0; j < exact.length; j++) {
                double error = Math.abs(actual[i][j] - exact[i][j]) / scale;
                if (!(error <= CORRECT) && first.isEmpty())
                    first =
                            "row %d, column %d is %s, right is %s"
                                    .formatted(i + 1, j + 1, actual[i][j], exact[i][j]);
                worst = Math.max(worst, Double.isNaN(error) ? Double.POSITIVE_INFINITY : error);
            }
        }
        return new Deviation(worst, 0, 0, of, first);
    }

    /** The fault of the rows' number or length; empty where there is none. */
    private static String shape(int size, double[][] rows) {
        if (rows == null || rows.length != size)
            return "%s where %d rows are right"
                    .formatted(rows == null ? "no matrix" : counted(rows.length, "row"), size);
        for (int i = 0; i < size; i++)
            if (rows[i] == null || rows[i].length != size) {
                int cells = rows[i] == null ? 0 : rows[i].length;
                return "row %d has %s, right are %d".formatted(i + 1, counted(cells, "cell"), size);
            }
        return "";
    }

    private static String counted(int count, String one) {
        return count + " " + one + (count == 1 ? "" : "s");
    }

    private static double scale(MatrixCall call, double[][] exact, int row) {
        double largest = Double.MIN_NORMAL;
        for (double cell : exact[row]) largest = Math.max(largest, Math.abs(cell));
        if (row < 3) return largest;
        int next = 0;
        for (MatrixParameter parameter : NamedMatrices.named(call.name()).parameters())
            for (int i = 0; i < parameter.size(); i++, next++)
                if (parameter.place())
                    largest = Math.max(largest, Math.abs(call.numbers().get(next)));
        return largest;
    }

    @Override
    public boolean correct(Deviation deviation) {
        return deviation.worst() <= CORRECT;
    }

    @Override
    public boolean usable(Deviation deviation) {
        return deviation.worst() <= USABLE;
    }

    /** How many cells there are, and how many of them have to be computed: those not 0 or 1. */
    @Override
    public Map<String, Long> operations(MatrixFormula method, MatrixCall call) {
        double[] cells =
                Arrays.stream(method.rows(call.name(), call.parameters()))
                        .flatMapToDouble(Arrays::stream)
                        .toArray();
        long computed = Arrays.stream(cells).filter(cell -> cell != 0 && cell != 1).count();
        return Map.of("cells", (long) cells.length, "cells-not-0-or-1", computed);
    }

    /** {@inheritDoc} Cells are counted in the answer, not in the work. */
    @Override
    public boolean isWork(String count) {
        return false;
    }

    @Override
    public String item() {
        return "matrix";
    }

    @Override
    public String errorUnit() {
        return "of the row's largest cell";
    }

    @Override
    public Format<MatrixFormula, MatrixCall, double[][]> format() {
        return new MatrixFormat(this);
    }
}
