package rasterlab.engine.transform.chain;

import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.EitherShape;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSink;
import rasterlab.engine.format.ValueSource;
import rasterlab.engine.transform.matrix.MatrixCall;
import rasterlab.engine.transform.matrix.MatrixFormat;

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
        if (in.startsObject()) return MatrixFormat.rows(in);
        if (!in.startsArray())
            throw in.invalid(
                    "expected a matrix: an object with its name, or an array of 3 or 4 rows");
        List<double[]> rows = ROWS.read(in);
        for (int i = 0; i < rows.size(); i++)
            if (rows.get(i).length != rows.size())
                throw new InvalidInput(
                        in.invalid("").place() + "/" + i,
                        "expected %d numbers, as many as the matrix has rows, got %d"
                                .formatted(rows.size(), rows.get(i).length));
        return rows.toArray(double[][]::new);
    }

    /** {@inheritDoc} By its rows: what it was called is not known any more. */
    @Override
    public void write(double[][] rows, ValueSink out) throws IOException {
        ROWS.write(List.of(rows), out);
    }
}
