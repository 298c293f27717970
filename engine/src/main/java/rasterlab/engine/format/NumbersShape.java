package rasterlab.engine.format;

import java.io.IOException;

/** An array of {@code least} to {@code most} finite numbers. */
record NumbersShape(int least, int most) implements Shape<double[]> {
    @Override
    public double[] read(ValueSource in) throws IOException {
        return in.numbers(least, most);
    }

    @Override
    public void write(double[] value, ValueSink out) throws IOException {
        out.numbers(value);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        ArraySchema.write(out, Shape.number(), least, most);
    }
}
