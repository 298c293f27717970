package rasterlab.engine.format;

import java.io.IOException;

/** An array of points, each an array of its coordinates, all of which go into one row. */
record PointsShape(int dimension, int least, int most) implements Shape<double[]> {
    @Override
    public double[] read(ValueSource in) throws IOException {
        return in.points(dimension, least, most);
    }

    @Override
    public void write(double[] value, ValueSink out) throws IOException {
        out.points(value, dimension);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        ArraySchema.write(out, Shape.numbers(dimension, dimension), least, most);
    }
}
