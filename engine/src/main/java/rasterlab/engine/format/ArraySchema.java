package rasterlab.engine.format;

import java.io.IOException;

/** The schema of an array. */
final class ArraySchema {
    private ArraySchema() {}

    static void write(ValueSink out, Shape<?> item, int least, int most) throws IOException {
        out.startObject();
        out.text("type", "array");
        out.name("items");
        item.schema(out);
        if (least > 0) out.whole("minItems", least);
        if (most < Integer.MAX_VALUE) out.whole("maxItems", most);
        out.endObject();
    }
}
