package rasterlab.app.cli.run.json;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rasterlab.app.outcome.Complaint;

/**
 * Reads one JSON object field by field and accepts nothing that was not asked for: no unknown or
 * repeated field, no other type, no wrong length, nothing behind the object.
 *
 * <p>Every complaint names the place as a JSON pointer (RFC 6901), the value and what is allowed.
 */
public final class StrictJson {
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
     * @param text UTF-8, of which the first {@code length} bytes count
     * @param fields the allowed fields
     * @throws Complaint if the text is anything else
     */
    public static Given object(byte[] text, int length, JsonField<?>... fields) {
        return object(text, length, json -> json.whole(json::object, fields));
    }

    /**
     * The same where what else is allowed depends on a field's value: {@link Given#unknown} names
     * the fields that are not among {@code fields}.
     *
     * @throws Complaint if the text is anything else
     */
    public static Given openObject(byte[] text, int length, JsonField<?>... fields) {
        return object(text, length, json -> json.whole(json::openObject, fields));
    }

    private static Given object(byte[] text, int length, JsonField.Reader<Given> reader) {
        try (JsonParser parser = FACTORY.createParser(text, 0, length)) {
            return read(new StrictJson(parser), text, length, reader);
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    private static Given read(
            StrictJson json, byte[] text, int length, JsonField.Reader<Given> reader)
            throws IOException {
        try {
            return reader.read(json);
        } catch (JacksonException e) {
            throw new NotJson(text, length).complaint(e, json.parser.currentLocation());
        }
    }

    /** Reads the object that the input stands on. */
    @FunctionalInterface
    private interface ObjectReader {
        Given read(JsonField<?>... fields) throws IOException;
    }

    private Given whole(ObjectReader reader, JsonField<?>... fields) throws IOException {
        if (parser.nextToken() == null)
            throw Complaint.badInput("the input is empty; expected " + anObjectWith(fields));
        Given given = reader.read(fields);
        if (parser.nextToken() != null)
            throw Complaint.badInput(
                    NotJson.place(parser.currentTokenLocation())
                            + ": "
                            + quoted()
                            + " follows the object; expected nothing more");
        return given;
    }

    /** Reads an object inside the input. */
    public Given object(JsonField<?>... fields) throws IOException {
        return object(false, fields);
    }

    /** The same for an object as {@link #openObject(byte[], int, JsonField[])} reads. */
    public Given openObject(JsonField<?>... fields) throws IOException {
        return object(true, fields);
    }

    private Given object(boolean open, JsonField<?>... fields) throws IOException {
        if (!startsObject()) throw expected(anObjectWith(fields));
        var given =
                new Given(parser.getParsingContext().pathAsPointer().toString(), List.of(fields));
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String name = parser.currentName();
            Optional<JsonField<?>> field = given.allowed(name);
            if (field.isEmpty() && !open)
                throw complaint("unknown field; allowed are " + sorted(fields));
            if (given.has(name)) throw complaint("the field is given twice");
            parser.nextToken();
            if (field.isPresent()) given.put(field.get(), field.get().reader().read(this));
            else passOver(given, name);
        }
        given.requireAll();
        return given;
    }

    private void passOver(Given given, String name) throws IOException {
        given.putUnknown(name);
        parser.skipChildren();
    }

    private static String anObjectWith(JsonField<?>... fields) {
        String required =
                Stream.of(fields)
                        .filter(JsonField::required)
                        .map(JsonField::name)
                        .collect(Collectors.joining(", "));
        return "a JSON object with " + (required.isEmpty() ? sorted(fields) : required);
    }

    private static String sorted(JsonField<?>... fields) {
        return Stream.of(fields).map(JsonField::name).sorted().collect(Collectors.joining(", "));
    }

    public boolean startsObject() {
        return parser.isExpectedStartObjectToken();
    }

    public boolean startsArray() {
        return parser.isExpectedStartArrayToken();
    }

    public boolean startsText() {
        return parser.currentToken() == JsonToken.VALUE_STRING;
    }

    public boolean isNull() {
        return parser.currentToken() == JsonToken.VALUE_NULL;
    }

    /**
     * Reads an array of {@code least} to {@code most} values.
     *
     * @param what the values in words, for complaints: "points"
     */
    public <T> List<T> list(String what, JsonField.Reader<T> reader, int least, int most)
            throws IOException {
        var values = new ArrayList<T>();
        each(what, least, most, () -> values.add(reader.read(this)));
        return values;
    }

    /** Reads an array of {@code least} to {@code most} finite numbers. */
    public double[] numbers(int least, int most) throws IOException {
        var values = new Doubles();
        each("numbers", least, most, () -> values.add(number()));
        return values.toArray();
    }

    /**
     * Reads an array of {@code least} to {@code most} points, each an array of {@code dimension}
     * finite numbers.
     *
     * @return the coordinates, point after point
     */
    public double[] points(int dimension, int least, int most) throws IOException {
        var values = new Doubles();
        String what = "points of " + dimension + " numbers each";
        each(
                what,
                least,
                most,
                () -> each("numbers", dimension, dimension, () -> values.add(number())));
        return values.toArray();
    }

    /** Reads an array of exactly {@code length} whole numbers in the range of int. */
    public int[] integers(int length) throws IOException {
        var values = IntStream.builder();
        each("whole numbers", length, length, () -> values.add(integer()));
        return values.build().toArray();
    }

    /** What is done with the value the input stands on. */
    @FunctionalInterface
    private interface Step {
        void take() throws IOException;
    }

    private void each(String what, int least, int most, Step step) throws IOException {
        String count = least == most ? "" + least : least + " to " + most;
        String expected = "an array of " + count + " " + what;
        if (!startsArray()) throw expected(expected);
        String array = pointer();
        int size = 0;
        for (; parser.nextToken() != JsonToken.END_ARRAY; size++) {
            if (size == most)
                throw Complaint.badInput(
                        array + ": more than " + most + " values; expected " + expected);
            step.take();
        }
        if (size < least)
            throw Complaint.badInput(array + ": only " + size + " values; expected " + expected);
    }

    /** Reads a finite number; one too small for a double is 0 or the smallest double. */
    public double number() throws IOException {
        return number("a number from -1.7976931348623157E308 to 1.7976931348623157E308");
    }

    private double number(String allowed) throws IOException {
        requireNumber(allowed);
        double value = Double.parseDouble(parser.getText());
        if (!Double.isFinite(value)) throw expected(allowed);
        return value;
    }

    /** Reads a whole number in the range of int. */
    public int integer() throws IOException {
        return integer(Integer.MIN_VALUE, Integer.MAX_VALUE);
    }

    /** Reads a number that is whole however it is written: 1, 1.0 and 1e0 are the same. */
    public int integer(int least, int most) throws IOException {
        String allowed = "a whole number from " + least + " to " + most;
        requireNumber(allowed);
        int value = whole(allowed);
        if (value < least || value > most) throw expected(allowed);
        return value;
    }

    private int whole(String allowed) throws IOException {
        try {
            return new BigDecimal(parser.getText()).intValueExact();
        } catch (ArithmeticException | NumberFormatException notWhole) {
            throw expected(allowed);
        }
    }

    private void requireNumber(String allowed) throws IOException {
        if (!parser.currentToken().isNumeric()) throw expected(allowed);
        if (parser.getTextLength() > LONGEST_NUMBER)
            throw expected(allowed + " in at most " + LONGEST_NUMBER + " characters");
    }

    /** Reads one of the words. */
    public String word(List<String> allowed) throws IOException {
        if (!startsText() || !allowed.contains(parser.getText()))
            throw expected("one of " + String.join(", ", allowed));
        return parser.getText();
    }

    /**
     * Reads a text of {@code least} to {@code most} 16-bit units, of which a character takes 1 or
     * 2.
     *
     * @param expected the text in words, for complaints
     */
    public String text(String expected, int least, int most) throws IOException {
        if (!startsText()) throw expected(expected);
        String text = parser.getText();
        if (text.length() < least || text.length() > most) throw expected(expected);
        return text;
    }

    /** Reads a number from {@code least} to {@code most}. */
    public double numberFrom(double least, double most) throws IOException {
        String allowed = "a number from " + least + " to " + most;
        double value = number(allowed);
        if (!(value >= least && value <= most)) throw expected(allowed);
        return value;
    }

    /** Reads a finite number above {@code least}, up to {@code most}. */
    public double numberAbove(double least, double most) throws IOException {
        String allowed = "a number above " + least + ", up to " + most;
        double value = number(allowed);
        if (!(value > least && value <= most)) throw expected(allowed);
        return value;
    }

    /**
     * Reads a value that is refused with an {@link IllegalArgumentException} where it is not
     * allowed, and complains of that at the value's place.
     */
    public <T> T checked(JsonField.Reader<T> reader) throws IOException {
        try {
            return reader.read(this);
        } catch (IllegalArgumentException e) {
            throw complaint(e.getMessage());
        }
    }

    private Complaint expected(String what) throws IOException {
        return complaint("expected " + what + ", got " + quoted());
    }

    /** A complaint about the value the input stands on, with its place. */
    public Complaint complaint(String message) {
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
