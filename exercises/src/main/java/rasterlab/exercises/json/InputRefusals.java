package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonParser;
import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Misfit;

/**
 * Refuses values of a topic's input, which is read from its beginning to its end: by the place as a
 * JSON pointer (RFC 6901), the value and what is allowed.
 */
final class InputRefusals extends Refusals {
    private static final int LONGEST_QUOTE = 40;

    InputRefusals(JsonParser parser) {
        super(parser);
    }

    @Override
    Misfit other(Expected allowed) throws IOException {
        return misfit("expected " + allowed.words() + ", got " + quoted());
    }

    @Override
    Misfit misfit(String reason) {
        String pointer = pointer();
        return new Misfit(pointer.isEmpty() ? "/" : shortened(pointer), reason);
    }

    @Override
    Misfit misfitOfArray(String reason) {
        String item = pointer();
        return new Misfit(shortened(item.substring(0, item.lastIndexOf('/'))), reason);
    }

    @Override
    Misfit unknown(List<Field<?>> fields) {
        return misfit("unknown field; allowed are " + new Expected.AnObject(fields).known());
    }

    @Override
    Misfit missing(Given object, Field<?> field) {
        return object.misfit(field.name(), "missing");
    }

    @Override
    String pointer() {
        return parser.getParsingContext().pathAsPointer().toString();
    }

    @Override
    int length() {
        return -1;
    }

    @Override
    boolean strict() {
        return false;
    }

    @Override
    StrictJson object(StrictJson reader, List<Field<?>> fields) {
        return reader;
    }

    /** The value that the reader stands on. */
    String quoted() throws IOException {
        return switch (parser.currentToken()) {
            case START_OBJECT, END_OBJECT -> "an object";
            case START_ARRAY, END_ARRAY -> "an array";
            case VALUE_STRING -> "the string \"" + shortened(parser.getText()) + "\"";
            default -> shortened(parser.getText());
        };
    }

    private static String shortened(String text) {
        return text.length() <= LONGEST_QUOTE ? text : text.substring(0, LONGEST_QUOTE) + "…";
    }
}
