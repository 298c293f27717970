package rasterlab.engine.format;

import java.io.IOException;

/** A flag: true or false. */
record FlagShape() implements Shape<Boolean> {
    @Override
    public Boolean read(ValueSource in) throws IOException {
        return in.flag();
    }

    @Override
    public void write(Boolean value, ValueSink out) throws IOException {
        out.flag(value);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.text("type", "boolean");
        out.endObject();
    }
}
