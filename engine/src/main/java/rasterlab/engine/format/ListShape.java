package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * An array of values of one shape.
 *
 * @param what the values in words, for complaints
 */
record ListShape<T>(String what, Shape<T> item, int least, int most) implements Shape<List<T>> {
    @Override
    public List<T> read(ValueSource in) throws IOException {
        return in.list(what, item, least, most);
    }

    @Override
    public void write(List<T> value, ValueSink out) throws IOException {
        out.startArray();
        for (T each : value) item.write(each, out);
        out.endArray();
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        ArraySchema.write(out, item, least, most);
    }
}
