package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/**
 * An array that is read as one shape and described place by place, as {@link DescribedShape} is.
 */
record PlacesShape<T>(Shape<T> read, List<Shape<?>> places) implements Shape<T> {
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
        out.startObject();
        out.text("type", "array");
        out.name("prefixItems");
        out.startArray();
        for (Shape<?> place : places) place.schema(out);
        out.endArray();
        out.whole("minItems", places.size());
        out.whole("maxItems", places.size());
        out.endObject();
    }
}
