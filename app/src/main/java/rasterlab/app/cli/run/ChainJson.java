package rasterlab.app.cli.run;

import java.io.IOException;
import java.util.List;
import rasterlab.app.cli.run.json.Given;
import rasterlab.app.cli.run.json.JsonField;
import rasterlab.app.cli.run.json.StrictJson;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.transform.chain.Chain;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.NamedMatrices;

/**
 * A list of matrices, each by name or by its rows, and the points that go through them, as JSON.
 *
 * <p>All matrices have 4 rows and the points 3 numbers, or all have 3 and the points 2. A point may
 * have one number more, its homogeneous coordinate h, which is 0 at infinity. Without matrices
 * points stay where they are.
 */
final class ChainJson {
    private static final int MOST_MATRICES = 1_000;
    private static final JsonField<List<double[][]>> MATRICES =
            JsonField.optional(
                    "matrices", json -> json.list("matrices", ChainJson::matrix, 0, MOST_MATRICES));
    private static final JsonField<List<double[]>> POINTS =
            JsonField.required(
                    "points",
                    json -> json.list("points", point -> point.numbers(2, 4), 0, PointJson.MOST));

    private ChainJson() {}

    static Chain read(byte[] text, int length) {
        Given given = StrictJson.object(text, length, MATRICES, POINTS);
        List<double[][]> matrices = given.find(MATRICES).orElse(List.of());
        List<double[]> points = given.get(POINTS);
        int dimension = dimension(matrices, points);
        for (int i = 0; i < matrices.size(); i++)
            if (matrices.get(i).length != dimension + 1)
                throw Complaint.badInput(
                        "/matrices/%d: has %d rows; expected %d as /matrices/0 has"
                                .formatted(i, matrices.get(i).length, dimension + 1));
        var coordinates = new double[points.size() * dimension];
        var h = new double[points.size()];
        for (int i = 0; i < points.size(); i++) {
            double[] point = points.get(i);
            if (point.length != dimension && point.length != dimension + 1)
                throw Complaint.badInput(
                        "/points/%d: has %d numbers; expected %d, one less than the matrices have rows, or %d, with h"
                                .formatted(i, point.length, dimension, dimension + 1));
            System.arraycopy(point, 0, coordinates, i * dimension, dimension);
            h[i] = point.length == dimension ? 1 : point[dimension];
        }
        return new Chain(
                dimension,
                matrices.stream().map(ChainJson::cells).toArray(double[][]::new),
                coordinates,
                h);
    }

    private static int dimension(List<double[][]> matrices, List<double[]> points) {
        if (!matrices.isEmpty()) return matrices.get(0).length - 1;
        return points.isEmpty() ? 3 : Math.min(3, points.get(0).length);
    }

    private static double[][] matrix(StrictJson json) throws IOException {
        if (json.startsObject()) return named(json);
        if (!json.startsArray())
            throw json.complaint(
                    "expected a matrix: an object with its name, or an array of 3 or 4 rows");
        List<double[]> rows = json.list("rows of 3 or 4 numbers", row -> row.numbers(3, 4), 3, 4);
        for (int i = 0; i < rows.size(); i++)
            if (rows.get(i).length != rows.size())
                throw json.complaint(
                        "a matrix has %d rows, but row %d has %d numbers; expected as many"
                                .formatted(rows.size(), i + 1, rows.get(i).length));
        return rows.toArray(double[][]::new);
    }

    private static double[][] named(StrictJson json) throws IOException {
        MatrixCall call = MatrixJson.read(json);
        double[] numbers = call.numbers().stream().mapToDouble(Double::doubleValue).toArray();
        try {
            return NamedMatrices.named(call.name()).rows(numbers);
        } catch (IllegalArgumentException e) {
            throw json.complaint(e.getMessage());
        }
    }

    private static double[] cells(double[][] rows) {
        var cells = new double[rows.length * rows.length];
        for (int i = 0; i < rows.length; i++)
            System.arraycopy(rows[i], 0, cells, i * rows.length, rows.length);
        return cells;
    }
}
