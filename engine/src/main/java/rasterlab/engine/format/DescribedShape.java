package rasterlab.engine.format;

import java.io.IOException;

/**
 * A value that is read as one shape and described as a narrower one: what the input as a whole
 * refuses, in words of its own, is not read as one field.
 */
record DescribedShape<T>(Shape<T> read, Shape<?> described) implements Shape<T> {
    @Override
    public T read(ValueSource in) throws IOException {
        return read.read(in);
    }

    @Override
    public void write(T value, ValueSink out) throws IOException {
        read.write(value, out);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        described.schema(out);
    }
}
