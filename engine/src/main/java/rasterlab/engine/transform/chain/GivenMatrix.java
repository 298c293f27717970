package rasterlab.engine.transform.chain;

import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixFormat;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** A matrix from outside: by its name, or by its rows. */
final class GivenMatrix extends EitherShape<double[][]> {
    private static final Shape<MatrixCall> NAMED = MatrixFormat.shape();
    private static final Shape<List<double[]>> ROWS =
            Shape.list("rows of 3 or 4 numbers", Shape.numbers(3, 4), 3, 4);

    GivenMatrix() {
        super(NAMED, ROWS);
    }

    @Override
    public double[][] read(ValueSource in) throws IOException {
        if (in.startsObject()) return named(in);
        if (!in.startsArray())
            throw in.misfit(
                    "expected a matrix: an object with its name, or an array of 3 or 4 rows");
        List<double[]> rows = ROWS.read(in);
        for (int i = 0; i < rows.size(); i++)
            if (rows.get(i).length != rows.size())
                throw in.misfit(
                        "a matrix has %d rows, but row %d has %d numbers; expected as many"
                                .formatted(rows.size(), i + 1, rows.get(i).length));
        return rows.toArray(double[][]::new);
    }

    /** {@inheritDoc} By its rows: what it was called is not known any more. */
    @Override
    public void write(double[][] rows, ValueSink out) throws IOException {
        ROWS.write(List.of(rows), out);
    }

    private static double[][] named(ValueSource in) throws IOException {
        MatrixCall call = NAMED.read(in);
        double[] numbers = call.numbers().stream().mapToDouble(Double::doubleValue).toArray();
        try {
            return NamedMatrices.named(call.name()).rows(numbers);
        } catch (IllegalArgumentException e) {
            throw in.misfit(e.getMessage());
        }
    }
}
