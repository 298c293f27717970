package rasterlab.engine.format;

import java.io.IOException;

/**
 * A value that is read as one shape and told as a narrower one: what the input as a whole refuses,
 * in words of its own, is not read as one field.
 */
record ToldShape<T>(Shape<T> read, Shape<?> told) implements Shape<T> {
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
        told.schema(out);
    }
}
