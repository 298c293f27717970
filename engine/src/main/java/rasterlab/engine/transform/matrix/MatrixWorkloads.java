package rasterlab.engine.transform.matrix;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.study.Workload;

/**
 * All matrices of 3 rows and all of 4, each with parameters that are the same in every run.
 *
 * <p>Writing a matrix down has no size that could grow: the number of rows is what there is.
 */
final class MatrixWorkloads {
    private static final long SEED = 1987;

    private MatrixWorkloads() {}

    static List<Workload<MatrixCall>> all() {
        return List.of(rows(3), rows(4));
    }

    private static Workload<MatrixCall> rows(int rows) {
        var random = new Random(SEED);
        var calls = new ArrayList<MatrixCall>();
        for (NamedMatrix matrix : NamedMatrices.all())
            if (matrix.size() == rows) calls.add(call(matrix, random));
        return new Workload<>("rows-" + rows, rows, calls);
    }

    /** Numbers between 0 and 1 are in the range of every parameter, and never two alike. */
    private static MatrixCall call(NamedMatrix matrix, Random random) {
        var numbers = new double[matrix.numbers()];
        for (int i = 0; i < numbers.length; i++) numbers[i] = random.nextDouble(0.01, 0.99);
        return MatrixCall.of(matrix.name(), numbers);
    }
}
