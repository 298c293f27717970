package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonParser.NumberType;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.app.outcome.Complaint;

/**
 * Reads one JSON object field by field and accepts nothing that was not asked for: no unknown or
 * repeated field, no other type, no wrong length, nothing behind the object.
 *
 * <p>Every complaint names the place as a JSON pointer (RFC 6901), the value and what is allowed.
 */
final class StrictJson {
    private static final JsonFactory FACTORY = new JsonFactory();
    private static final int LONGEST_QUOTE = 40;

    private final JsonParser parser;

    private StrictJson(JsonParser parser) {
        this.parser = parser;
    }

    /**
     * Reads the object that {@code text} holds.
     *
     * @param text UTF-8
     * @param fields the allowed fields, each with what reads its value
     * @param required the fields that must be there
     * @return the values given, in the order of the text
     * @throws Complaint if the text is anything else
     */
    static <T> Map<String, T> object(
            byte[] text, int length, Map<String, Field<T>> fields, List<String> required) {
        try (JsonParser parser = FACTORY.createParser(text, 0, length)) {
            return new StrictJson(parser).object(fields, required);
        } catch (JacksonException e) {
            throw Complaint.badInput(
                    place(e.getLocation()) + ": not JSON: " + e.getOriginalMessage());
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    /** Reads the value of a field; the parser stands on its first token. */
    @FunctionalInterface
    interface Field<T> {
        T read(StrictJson json) throws IOException;
    }

    private <T> Map<String, T> object(Map<String, Field<T>> fields, List<String> required)
            throws IOException {
        if (parser.nextToken() == null)
            throw Complaint.badInput("the input is empty; expected a JSON object" + list(required));
        if (!parser.isExpectedStartObjectToken()) throw expected("a JSON object" + list(required));
        Map<String, T> values = new LinkedHashMap<>();
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String name = parser.currentName();
            Field<T> field = fields.get(name);
            if (field == null) throw complaint("unknown field; allowed are " + sorted(fields));
            if (values.containsKey(name)) throw complaint("the field is given twice");
            parser.nextToken();
            values.put(name, field.read(this));
        }
        for (String name : required)
            if (!values.containsKey(name)) throw Complaint.badInput("/" + name + ": missing");
        if (parser.nextToken() != null)
            throw Complaint.badInput(
                    place(parser.currentTokenLocation())
                            + ": "
                            + quoted()
                            + " follows the object; expected nothing more");
        return values;
    }

    private static String list(List<String> required) {
        return " with " + String.join(", ", required);
    }

    private static List<String> sorted(Map<String, ?> fields) {
        return fields.keySet().stream().sorted().toList();
    }

    /** Reads an array of exactly {@code length} whole numbers in the range of int. */
    int[] integers(int length) throws IOException {
        String expected = "an array of " + length + " whole numbers";
        if (!parser.isExpectedStartArrayToken()) throw expected(expected);
        String array = pointer();
        var values = new int[length];
        int count = 0;
        for (; parser.nextToken() != JsonToken.END_ARRAY; count++) {
            if (count == length)
                throw Complaint.badInput(
                        array + ": more than " + length + " values; expected " + expected);
            values[count] = integer();
        }
        if (count < length)
            throw Complaint.badInput(array + ": only " + count + " values; expected " + expected);
        return values;
    }

    private int integer() throws IOException {
        String allowed = "a whole number from " + Integer.MIN_VALUE + " to " + Integer.MAX_VALUE;
        if (parser.currentToken() != JsonToken.VALUE_NUMBER_INT
                || parser.getNumberType() != NumberType.INT) throw expected(allowed);
        return parser.getIntValue();
    }

    private Complaint expected(String what) throws IOException {
        return complaint("expected " + what + ", got " + quoted());
    }

    private Complaint complaint(String message) {
        return Complaint.badInput(pointer() + ": " + message);
    }

    private String pointer() {
        String pointer = parser.getParsingContext().pathAsPointer().toString();
        return pointer.isEmpty() ? "/" : shortened(pointer);
    }

    private String quoted() throws IOException {
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

    private static String place(JsonLocation at) {
        return "line " + at.getLineNr() + ", column " + at.getColumnNr();
    }
}
