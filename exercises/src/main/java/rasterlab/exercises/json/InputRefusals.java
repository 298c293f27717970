package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonParser;
import java.io.IOException;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.InvalidInput;

/**
 * Refuses values of a topic's input, which is read from its beginning to its end: by the place as a
 * JSON pointer (RFC 6901), the value and what is allowed.
 */
final class InputRefusals implements Refusals {
    private static final int LONGEST_QUOTE = 40;

    private final JsonParser parser;
    private final boolean lacking;

    InputRefusals(JsonParser parser) {
        this(parser, false);
    }

    private InputRefusals(JsonParser parser, boolean lacking) {
        this.parser = parser;
        this.lacking = lacking;
    }

    /** Refuses a null that stands for a value that was not given. */
    static InputRefusals ofLacking(JsonParser parser) {
        return new InputRefusals(parser, true);
    }

    @Override
    public InvalidInput other(Expected allowed) throws IOException {
        return invalid(
                lacking
                        ? "missing; expected " + allowed.words()
                        : "expected " + allowed.words() + ", got " + quoted());
    }

    @Override
    public InvalidInput invalid(String reason) {
        String pointer = pointer();
        return new InvalidInput(pointer.isEmpty() ? "/" : shortened(pointer), reason);
    }

    @Override
    public InvalidInput invalidArray(String reason) {
        String item = pointer();
        return new InvalidInput(shortened(item.substring(0, item.lastIndexOf('/'))), reason);
    }

    @Override
    public InvalidInput unknown(List<Field<?>> fields) {
        return invalid("unknown field; allowed are " + new Expected.AnObject(fields).known());
    }

    @Override
    public InvalidInput missing(Given object, Field<?> field) {
        return object.invalid(field.name(), StrictJson.lacking(field));
    }

    @Override
    public String pointer() {
        return parser.getParsingContext().pathAsPointer().toString();
    }

    @Override
    public int length() {
        return -1;
    }

    @Override
    public boolean strict() {
        return false;
    }

    @Override
    public StrictJson object(StrictJson reader, List<Field<?>> fields) {
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
