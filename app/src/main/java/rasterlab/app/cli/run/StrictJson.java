package rasterlab.app.cli.run;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.IOException;
import java.math.BigDecimal;
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
    /** The most characters of one name, text or number that is read, to be complained about. */
    static final int LONGEST_TOKEN = 1 << 20;

    /** NaN is read as a number, so that the complaint about it can name its place. */
    private static final JsonFactory FACTORY =
            JsonFactory.builder()
                    .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
                    .streamReadConstraints(
                            StreamReadConstraints.builder()
                                    .maxNameLength(LONGEST_TOKEN)
                                    .maxStringLength(LONGEST_TOKEN)
                                    .maxNumberLength(LONGEST_TOKEN)
                                    .build())
                    .build();

    /**
     * The most characters of an accepted number; the time to convert one grows with their square.
     */
    private static final int LONGEST_NUMBER = 1000;

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
            return read(new StrictJson(parser), text, length, fields, required);
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    private static <T> Map<String, T> read(
            StrictJson json,
            byte[] text,
            int length,
            Map<String, Field<T>> fields,
            List<String> required)
            throws IOException {
        try {
            return json.object(fields, required);
        } catch (JacksonException e) {
            throw new NotJson(text, length).complaint(e, json.parser.currentLocation());
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
                    NotJson.place(parser.currentTokenLocation())
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

    /** A number that is whole however it is written: 1, 1.0 and 1e0 are the same. */
    private int integer() throws IOException {
        String allowed = "a whole number from " + Integer.MIN_VALUE + " to " + Integer.MAX_VALUE;
        if (!parser.currentToken().isNumeric()) throw expected(allowed);
        if (parser.getTextLength() > LONGEST_NUMBER)
            throw expected(allowed + " in at most " + LONGEST_NUMBER + " characters");
        try {
            return new BigDecimal(parser.getText()).intValueExact();
        } catch (ArithmeticException | NumberFormatException notWhole) {
            throw expected(allowed);
        }
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
}
