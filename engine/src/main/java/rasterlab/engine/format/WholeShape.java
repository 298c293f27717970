package rasterlab.engine.format;

import java.io.IOException;

/** A whole number of a range, however it is written: 1, 1.0 and 1e0 are the same. */
record WholeShape(int least, int most) implements Shape<Integer> {
    @Override
    public Integer read(ValueSource in) throws IOException {
        return in.whole(least, most);
    }

    @Override
    public void write(Integer value, ValueSink out) throws IOException {
        out.whole(value);
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.text("type", "integer");
        out.whole("minimum", least);
        out.whole("maximum", most);
        out.endObject();
    }
}
