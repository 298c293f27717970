package rasterlab.engine.format;

import java.io.IOException;
import java.util.List;

/** An object with certain fields and no others. */
public record ObjectShape(List<Field<?>> fields) implements Shape<Given> {
    @Override
    public Given read(ValueSource in) throws IOException {
        return in.object(fields);
    }

    @Override
    public void write(Given value, ValueSink out) throws IOException {
        out.startObject();
        value.write(fields, out);
        out.endObject();
    }

    @Override
    public void schema(ValueSink out) throws IOException {
        out.startObject();
        writeSchema(out);
        out.endObject();
    }

    /** Writes what {@link #schema} says into an object that says more. */
    public void writeSchema(ValueSink out) throws IOException {
        out.text("type", "object");
        out.name("properties");
        out.startObject();
        for (Field<?> field : fields) {
            out.name(field.name());
            field.schema(out);
        }
        out.endObject();
        out.name("required");
        out.startArray();
        for (Field<?> field : fields) if (field.required()) out.text(field.name());
        out.endArray();
        out.name("additionalProperties");
        out.flag(false);
    }
}
