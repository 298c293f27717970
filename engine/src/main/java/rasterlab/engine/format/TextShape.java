package rasterlab.engine.format;

import java.io.IOException;

/**
 * A text of {@code least} to {@code most} 16-bit units, of which a character takes 1 or 2.
 *
 * @param what the text in words, for complaints
 */
record TextShape(String what, int least, int most) implements Shape<String> {
    @Override
    public String read(ValueSource in) throws IOException {
        return in.text(what, least, most);
    }

    @Override
    public void write(String value, ValueSink out) throws IOException {
        out.text(value);
    }

    /** {@inheritDoc} JSON Schema counts characters, of which there are at most as many as units. */
    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.text("type", "string");
        if (least > 0) out.whole("minLength", (least + 1) / 2);
        if (most < Integer.MAX_VALUE) out.whole("maxLength", most);
        out.endObject();
    }
}
