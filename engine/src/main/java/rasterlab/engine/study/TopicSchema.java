package rasterlab.engine.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.ObjectShape;
import rasterlab.engine.format.StepsShape;
import rasterlab.engine.format.ValueSink;

/**
 * A topic's JSON Schema, draft 2020-12: of its inputs, and under {@code $defs} of inputs and
 * answers by name.
 */
public final class TopicSchema {
    private static final String DRAFT = "https://json-schema.org/draft/2020-12/schema";

    private TopicSchema() {}

    /** Writes the fields of the schema. */
    public static void write(Format<?, ?, ?> format, ValueSink out) throws IOException {
        out.text("$schema", DRAFT);
        out.text("title", format.topic().name());
        out.text("$ref", "#/$defs/input");
        out.name("$defs");
        out.startObject();
        out.name("input");
        out.startObject();
        out.text("description", format.reads());
        format.writeInputSchema(out);
        out.endObject();
        out.name("output");
        out.startObject();
        out.text("description", format.answers());
        new ObjectShape(withSteps(format)).writeSchema(out);
        out.endObject();
        out.endObject();
    }

    private static List<Field<?>> withSteps(Format<?, ?, ?> format) {
        var fields = new ArrayList<>(format.answer());
        if (format.hasSteps()) fields.addAll(List.of(StepsShape.DECISION, StepsShape.FIELD));
        return fields;
    }

    /**
     * Writes what one group of fields, of which an input has all, says about the others.
     *
     * @param groups exactly one of which an input has
     */
    static void writeOneOf(List<List<Field<?>>> groups, ValueSink out) throws IOException {
        out.name("oneOf");
        out.startArray();
        for (List<Field<?>> group : groups) {
            out.startObject();
            out.name("required");
            out.startArray();
            for (Field<?> field : group) out.text(field.name());
            out.endArray();
            out.name("properties");
            out.startObject();
            for (List<Field<?>> other : groups)
                if (other != group) for (Field<?> field : other) out.flag(field.name(), false);
            out.endObject();
            out.endObject();
        }
        out.endArray();
    }
}
