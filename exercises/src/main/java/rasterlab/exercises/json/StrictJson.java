package rasterlab.exercises.json;

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
import java.util.stream.Collectors;
import rasterlab.engine.format.Doubles;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.Misfit;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSource;

/**
 * Reads one JSON object field by field and accepts nothing that was not asked for: no unknown or
 * repeated field, no other type, no wrong length, nothing behind the object.
 *
 * <p>Every complaint names the place as a JSON pointer (RFC 6901), the value and what is allowed.
 */
public final class StrictJson implements ValueSource {
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

    private static final String NUMBERS = "numbers";
    private static final String WHOLES = "whole numbers";

    private final JsonParser parser;

    private StrictJson(JsonParser parser) {
        this.parser = parser;
    }

    /**
     * Reads the object that {@code text} holds.
     *
     * @param text UTF-8, of which the first {@code length} bytes count
     * @param fields the allowed fields
     * @param open whether more are, whose names {@link Given#unknown} tells
     * @throws Misfit if the text is anything else
     */
    public static Given read(byte[] text, int length, List<Field<?>> fields, boolean open) {
        try (JsonParser parser = FACTORY.createParser(text, 0, length)) {
            return new StrictJson(parser).whole(text, length, fields, open);
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    private Given whole(byte[] text, int length, List<Field<?>> fields, boolean open)
            throws IOException {
        try {
            return whole(fields, open);
        } catch (JacksonException e) {
            throw new NotJson(text, length).misfit(e, parser.currentLocation());
        }
    }

    private Given whole(List<Field<?>> fields, boolean open) throws IOException {
        if (parser.nextToken() == null)
            throw new Misfit("the input is empty; expected " + anObjectWith(fields));
        Given given = object(open, fields);
        if (parser.nextToken() != null)
            throw new Misfit(
                    NotJson.place(parser.currentTokenLocation()),
                    quoted() + " follows the object; expected nothing more");
        return given;
    }

    @Override
    public Given object(List<Field<?>> fields) throws IOException {
        return object(false, fields);
    }

    @Override
    public Given openObject(List<Field<?>> fields) throws IOException {
        return object(true, fields);
    }

    private Given object(boolean open, List<Field<?>> fields) throws IOException {
        if (!startsObject()) throw expected(anObjectWith(fields));
        var given = new Given(path());
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String name = parser.currentName();
            Field<?> field = named(name, fields);
            if (field == null && !open)
                throw misfit("unknown field; allowed are " + sorted(fields));
            if (given.has(name)) throw misfit("the field is given twice");
            parser.nextToken();
            if (field != null) given.put(field, field.shape().read(this));
            else passOver(given, name);
        }
        for (Field<?> field : fields)
            if (field.required() && !given.has(field)) throw given.misfit(field.name(), "missing");
        return given;
    }

    private static Field<?> named(String name, List<Field<?>> fields) {
        for (Field<?> field : fields) if (field.name().equals(name)) return field;
        return null;
    }

    private void passOver(Given given, String name) throws IOException {
        given.putUnknown(name);
        parser.skipChildren();
    }

    private static String anObjectWith(List<Field<?>> fields) {
        String required =
                fields.stream()
                        .filter(Field::required)
                        .map(Field::name)
                        .collect(Collectors.joining(", "));
        return "a JSON object with " + (required.isEmpty() ? sorted(fields) : required);
    }

    private static String sorted(List<Field<?>> fields) {
        return fields.stream().map(Field::name).sorted().collect(Collectors.joining(", "));
    }

    @Override
    public boolean startsObject() {
        return parser.isExpectedStartObjectToken();
    }

    @Override
    public boolean startsArray() {
        return parser.isExpectedStartArrayToken();
    }

    @Override
    public boolean startsText() {
        return parser.currentToken() == JsonToken.VALUE_STRING;
    }

    @Override
    public boolean isNull() {
        return parser.currentToken() == JsonToken.VALUE_NULL;
    }

    @Override
    public <T> List<T> list(String what, Shape<T> item, int least, int most) throws IOException {
        var values = new ArrayList<T>();
        startArray(what, least, most);
        while (hasNext(what, values.size(), least, most)) values.add(item.read(this));
        return values;
    }

    @Override
    public double[] numbers(int least, int most) throws IOException {
        var values = new Doubles();
        addNumbers(values, least, most);
        return values.toArray();
    }

    private void addNumbers(Doubles values, int least, int most) throws IOException {
        startArray(NUMBERS, least, most);
        for (int size = 0; hasNext(NUMBERS, size, least, most); size++) values.add(number());
    }

    @Override
    public double[] points(int dimension, int least, int most) throws IOException {
        var values = new Doubles();
        String what = "points of " + dimension + " numbers each";
        startArray(what, least, most);
        for (int size = 0; hasNext(what, size, least, most); size++)
            addNumbers(values, dimension, dimension);
        return values.toArray();
    }

    @Override
    public int[] wholes(int count) throws IOException {
        var values = new int[count];
        startArray(WHOLES, count, count);
        for (int size = 0; hasNext(WHOLES, size, count, count); size++)
            values[size] = whole(Integer.MIN_VALUE, Integer.MAX_VALUE);
        return values;
    }

    private void startArray(String what, int least, int most) throws IOException {
        if (!startsArray()) throw expected(anArray(what, least, most));
    }

    private static String anArray(String what, int least, int most) {
        String count = least == most ? "" + least : least + " to " + most;
        return "an array of " + count + " " + what;
    }

    /**
     * Goes on to the next value of an array.
     *
     * @param size how many values were read
     */
    private boolean hasNext(String what, int size, int least, int most) throws IOException {
        if (parser.nextToken() == JsonToken.END_ARRAY) {
            if (size >= least) return false;
            throw misfit("only " + size + " values; expected " + anArray(what, least, most));
        }
        if (size < most) return true;
        String beyond = path();
        throw new Misfit(
                shortened(beyond.substring(0, beyond.lastIndexOf('/'))),
                "more than " + most + " values; expected " + anArray(what, least, most));
    }

    @Override
    public double number() throws IOException {
        return number("a number from -1.7976931348623157E308 to 1.7976931348623157E308");
    }

    private double number(String allowed) throws IOException {
        requireNumber(allowed);
        double value = Double.parseDouble(parser.getText());
        if (!Double.isFinite(value)) throw expected(allowed);
        return value;
    }

    /** {@inheritDoc} A number is whole however it is written: 1, 1.0 and 1e0 are the same. */
    @Override
    public int whole(int least, int most) throws IOException {
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

    @Override
    public boolean flag() throws IOException {
        if (!parser.currentToken().isBoolean()) throw expected("true or false");
        return parser.getBooleanValue();
    }

    @Override
    public String word(List<String> allowed) throws IOException {
        if (!startsText() || !allowed.contains(parser.getText()))
            throw expected("one of " + String.join(", ", allowed));
        return parser.getText();
    }

    @Override
    public String text(String expected, int least, int most) throws IOException {
        if (!startsText()) throw expected(expected);
        String text = parser.getText();
        if (text.length() < least || text.length() > most) throw expected(expected);
        return text;
    }

    @Override
    public double numberFrom(double least, double most) throws IOException {
        String allowed = "a number from " + least + " to " + most;
        double value = number(allowed);
        if (!(value >= least && value <= most)) throw expected(allowed);
        return value;
    }

    @Override
    public double numberAbove(double least, double most) throws IOException {
        String allowed = "a number above " + least + ", up to " + most;
        double value = number(allowed);
        if (!(value > least && value <= most)) throw expected(allowed);
        return value;
    }

    private Misfit expected(String what) throws IOException {
        return misfit("expected " + what + ", got " + quoted());
    }

    @Override
    public Misfit misfit(String reason) {
        return new Misfit(pointer(), reason);
    }

    private String pointer() {
        String path = path();
        return path.isEmpty() ? "/" : shortened(path);
    }

    /** The JSON pointer of the value that the input stands on. */
    private String path() {
        return parser.getParsingContext().pathAsPointer().toString();
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
