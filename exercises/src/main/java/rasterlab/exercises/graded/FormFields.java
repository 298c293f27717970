package rasterlab.exercises.graded;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.FieldKind;
import rasterlab.engine.study.Format;

/**
 * The values of an input and of answers to it, by what the topic's format says that they are.
 *
 * @param input as {@code ./lab run} takes it
 */
record FormFields(Format<?, ?, ?> format, JsonNode input) {
    /** The values of that kind which the input has. */
    List<JsonNode> given(FieldKind kind) {
        return values(format.input(), input, kind).toList();
    }

    /** The first of them; missing where there is none. */
    JsonNode one(FieldKind kind) {
        return given(kind).stream().findFirst().orElse(input.path(""));
    }

    /** The values of that kind which an answer has. */
    List<JsonNode> answered(JsonNode answer, FieldKind kind) {
        return values(format.answer(), answer, kind).toList();
    }

    private static Stream<JsonNode> values(List<Field<?>> fields, JsonNode of, FieldKind kind) {
        return fields.stream()
                .filter(field -> field.kind() == kind && of.has(field.name()))
                .map(field -> of.get(field.name()));
    }
}
