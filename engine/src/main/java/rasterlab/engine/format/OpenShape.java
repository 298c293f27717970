package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/** An object with any fields. */
record OpenShape() implements Shape<Given> {
    @Override
    public Given read(ValueSource in) throws IOException {
        return in.openObject(List.of());
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        out.text("type", "object");
        out.endObject();
    }
}
