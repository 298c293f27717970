package rasterlab.engine.format;

import java.io.IOException;

/** An object whose fields are written by code of their own, a part of an answer. */
public class OpenShape implements Shape<Written> {
    /** {@inheritDoc} Nobody reads answers. */
    @Override
    public final Written read(ValueSource in) {
        throw in.invalid("is written, but not read");
    }

    @Override
    public final void write(Written value, ValueSink out) throws IOException {
        out.startObject();
        value.write(out);
        out.endObject();
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.text("type", "object");
        out.endObject();
    }
}
