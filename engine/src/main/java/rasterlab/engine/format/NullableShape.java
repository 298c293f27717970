package rasterlab.engine.format;

import java.io.IOException;

/** A value that may be null. */
final class NullableShape<T> extends EitherShape<T> {
    private final Shape<T> shape;

    NullableShape(Shape<T> shape) {
        super(shape, new NullShape());
        this.shape = shape;
    }

    @Override
    public T read(ValueSource in) throws IOException {
        return in.isNull() ? null : shape.read(in);
    }

    @Override
    public void write(T value, ValueSink out) throws IOException {
        if (value == null) out.nothing();
        else shape.write(value, out);
    }

    /** The shape of null alone. */
    private static final class NullShape implements Shape<Void> {
        @Override
        public Void read(ValueSource in) {
            if (!in.isNull()) throw in.invalid("expected null");
            return null;
        }

        @Override
        public void write(Void value, ValueSink out) throws IOException {
            out.nothing();
        }

        @Override
        public void schema(ValueSink out) throws IOException {
            out.startObject();
            out.text("type", "null");
            out.endObject();
        }
    }
}
