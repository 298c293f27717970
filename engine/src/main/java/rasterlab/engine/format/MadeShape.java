package rasterlab.engine.format;

import java.io.IOException;

/**
 * A value from which something is made that refuses some values of its shape by {@link
 * IllegalArgumentException}.
 *
 * @param <S> what a value of the shape is
 * @param <T> what is made of it
 */
public abstract class MadeShape<S, T> implements Shape<T> {
    private final Shape<S> shape;

    protected MadeShape(Shape<S> shape) {
        this.shape = shape;
    }

    /**
     * Makes something of the value.
     *
     * @throws IllegalArgumentException if it cannot; the message is told with the value's place, or
     *     that of the field whose name it begins with
     */
    protected abstract T made(S value);

    /** The value of which {@link #made} makes {@code thing}. */
    protected abstract S value(T thing);

    @Override
    public final T read(ValueSource in) throws IOException {
        S value = shape.read(in);
        try {
            return made(value);
        } catch (IllegalArgumentException e) {
            throw value instanceof Given fields ? fields.invalid(e) : in.invalid(e.getMessage());
        }
    }

    @Override
    public final void write(T thing, ValueSink out) throws IOException {
        shape.write(value(thing), out);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        shape.schema(out);
    }
}
