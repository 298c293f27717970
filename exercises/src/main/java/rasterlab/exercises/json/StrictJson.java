package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Given;
import rasterlab.engine.format.GrowingDoubles;
import rasterlab.engine.format.InvalidInput;
import rasterlab.engine.format.Shape;
import rasterlab.engine.format.ValueSource;

/**
 * Reads JSON value by value and accepts nothing that was not asked for: no unknown or repeated
 * field, no other type, no wrong length, nothing behind the whole.
 *
 * <p>What it reads is the text of an input, or the tree of a file of people. Every refusal names
 * the place, the value and what is allowed; how, depends on which of them it is.
 */
public final class StrictJson implements ValueSource {
    /** The most characters of one name, text or number that is read, to be complained about. */
    private static final int LONGEST_TOKEN = 1 << 20;

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

    private static final Expected ANY_WHOLE =
            new Expected.Whole(Integer.MIN_VALUE, Integer.MAX_VALUE, true);

    private final JsonParser parser;
    private final Refusals refusals;

    private StrictJson(JsonParser parser, Refusals refusals) {
        this.parser = parser;
        this.refusals = refusals;
    }

    /**
     * Reads the object that {@code text} holds.
     *
     * @param text UTF-8, of which the first {@code length} bytes count
     * @param fields the allowed fields
     * @param open whether more are, whose names {@link Given#unknown} tells
     * @throws InvalidInput if the text is anything else
     */
    public static Given read(byte[] text, int length, List<Field<?>> fields, boolean open) {
        new Utf8Text(text, length).require();
        try (JsonParser parser = FACTORY.createParser(text, 0, length)) {
            return read(parser, fields, open);
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    private static Given read(JsonParser parser, List<Field<?>> fields, boolean open)
            throws IOException {
        try {
            return whole(parser, fields, open);
        } catch (JsonProcessingException e) {
            throw JsonMistake.invalid(e, parser.currentLocation());
        }
    }

    private static Given whole(JsonParser parser, List<Field<?>> fields, boolean open)
            throws IOException {
        var refusals = new InputRefusals(parser);
        if (parser.nextToken() == null)
            throw new InvalidInput(
                    "the input is empty; expected " + new Expected.AnObject(fields).words());
        Given given = new StrictJson(parser, refusals).object(open, fields);
        if (parser.nextToken() != null)
            throw new InvalidInput(
                    JsonMistake.place(parser.currentTokenLocation()),
                    refusals.quoted() + " follows the object; expected nothing more");
        return given;
    }

    /** Says that a field is missing and what it may hold, as its shape would refuse null. */
    static String lacking(Field<?> field) {
        try (JsonParser parser = FACTORY.createParser("null")) {
            parser.nextToken();
            field.shape().read(new StrictJson(parser, InputRefusals.ofLacking(parser)));
            return "missing";
        } catch (InvalidInput e) {
            return e.reason();
        } catch (IOException e) {
            throw new AssertionError("reading from memory failed", e);
        }
    }

    /** Reads the value at a place of a file of people, which refuses in words of its own. */
    static StrictJson at(JsonPlace<?> place) throws IOException {
        return at(place, place.node());
    }

    /**
     * Reads the value at a place.
     *
     * @param value the place's own, or one with its fields in another order
     */
    static StrictJson at(JsonPlace<?> place, JsonNode value) throws IOException {
        JsonParser parser = value.traverse();
        parser.nextToken();
        return new StrictJson(parser, new PlaceRefusals(place, parser));
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
        if (!startsObject()) throw refusals.other(new Expected.AnObject(fields));
        return refusals.object(this, fields).fields(open, fields);
    }

    private Given fields(boolean open, List<Field<?>> fields) throws IOException {
        var given = new Given(refusals.pointer());
        while (parser.nextToken() == JsonToken.FIELD_NAME) {
            String name = parser.currentName();
            Field<?> field = named(name, fields);
            if (field == null && !open) throw refusals.unknown(fields);
            if (given.has(name)) throw invalid("the field is given twice");
            parser.nextToken();
            if (field != null) given.put(field, field.shape().read(this));
            else passOver(given, name);
        }
        for (Field<?> field : fields)
            if (field.required() && !given.has(field)) throw refusals.missing(given, field);
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

    @Override
    public boolean startsObject() {
        return parser.isExpectedStartObjectToken();
    }

    @Override
    public boolean startsArray() {
        return parser.isExpectedStartArrayToken();
    }

    private boolean startsText() {
        return parser.currentToken() == JsonToken.VALUE_STRING;
    }

    @Override
    public boolean isNull() {
        return parser.currentToken() == JsonToken.VALUE_NULL;
    }

    @Override
    public <T> List<T> list(String what, Shape<T> item, int least, int most) throws IOException {
        var values = new ArrayList<T>();
        var items = new Expected.Items(what, "", least, most);
        startArray(items, least, most);
        while (hasNext(items, values.size(), least, most)) values.add(item.read(this));
        return values;
    }

    @Override
    public double[] numbers(int least, int most) throws IOException {
        var values = new GrowingDoubles();
        addNumbers(values, new Expected.Items("numbers", "", least, most), least, most);
        return values.toArray();
    }

    private void addNumbers(GrowingDoubles values, Expected numbers, int least, int most)
            throws IOException {
        startArray(numbers, least, most);
        for (int size = 0; hasNext(numbers, size, least, most); size++) values.add(number());
    }

    @Override
    public double[] points(int dimension, int least, int most) throws IOException {
        var values = new GrowingDoubles();
        String each = " of " + dimension + " numbers each";
        var points = new Expected.Items("points", each, least, most);
        var point = new Expected.Items("numbers", "", dimension, dimension);
        startArray(points, least, most);
        for (int size = 0; hasNext(points, size, least, most); size++)
            addNumbers(values, point, dimension, dimension);
        return values.toArray();
    }

    @Override
    public int[] wholes(int count) throws IOException {
        var values = new int[count];
        var wholes = new Expected.Wholes(count);
        startArray(wholes, count, count);
        for (int size = 0; hasNext(wholes, size, count, count); size++)
            values[size] = whole(Integer.MIN_VALUE, Integer.MAX_VALUE, ANY_WHOLE);
        return values;
    }

    private void startArray(Expected array, int least, int most) throws IOException {
        if (!startsArray()) throw refusals.other(array);
        int length = refusals.length();
        if (length >= 0 && (length < least || length > most)) throw refusals.other(array);
    }

    /**
     * Goes on to the next value of an array.
     *
     * @param size how many values were read
     */
    private boolean hasNext(Expected array, int size, int least, int most) throws IOException {
        if (parser.nextToken() == JsonToken.END_ARRAY) {
            if (size >= least) return false;
            throw invalid("only " + values(size) + "; expected " + array.words());
        }
        if (size < most) return true;
        throw refusals.invalidArray("more than " + values(most) + "; expected " + array.words());
    }

    private static String values(int count) {
        return count == 1 ? "1 value" : count + " values";
    }

    @Override
    public double number() throws IOException {
        return number(Expected.Number.ANY);
    }

    private double number(Expected allowed) throws IOException {
        requireNumber(allowed);
        double value = Double.parseDouble(parser.getText());
        if (!Double.isFinite(value)) throw refusals.other(allowed);
        return value;
    }

    /**
     * {@inheritDoc} In an input a number is whole however it is written: 1, 1.0 and 1e0 are the
     * same.
     */
    @Override
    public int whole(int least, int most) throws IOException {
        return whole(least, most, new Expected.Whole(least, most, false));
    }

    private int whole(int least, int most, Expected allowed) throws IOException {
        requireNumber(allowed);
        if (refusals.strict() && parser.currentToken() != JsonToken.VALUE_NUMBER_INT)
            throw refusals.other(allowed);
        int value = whole(allowed);
        if (value < least || value > most) throw refusals.other(allowed);
        return value;
    }

    private int whole(Expected allowed) throws IOException {
        try {
            return new BigDecimal(parser.getText()).intValueExact();
        } catch (ArithmeticException | NumberFormatException notWhole) {
            throw refusals.other(allowed);
        }
    }

    private void requireNumber(Expected allowed) throws IOException {
        if (!parser.currentToken().isNumeric()) throw refusals.other(allowed);
        if (parser.getTextLength() > LONGEST_NUMBER)
            throw refusals.other(new Expected.Shorter(allowed, LONGEST_NUMBER));
    }

    @Override
    public boolean flag() throws IOException {
        if (!parser.currentToken().isBoolean()) throw refusals.other(new Expected.Flag());
        return parser.getBooleanValue();
    }

    @Override
    public String word(List<String> allowed) throws IOException {
        if (!startsText() || !allowed.contains(parser.getText()))
            throw refusals.other(new Expected.Word(allowed));
        return parser.getText();
    }

    @Override
    public String text(String expected, int least, int most) throws IOException {
        if (!startsText()) throw refusals.other(new Expected.Text(expected));
        String text = parser.getText();
        if (text.length() < least || text.length() > most || refusals.strict() && text.isBlank())
            throw refusals.other(new Expected.Text(expected));
        return text;
    }

    @Override
    public double numberFrom(double least, double most) throws IOException {
        var allowed = new Expected.Number(least, most);
        double value = number(allowed);
        if (!(value >= least && value <= most)) throw refusals.other(allowed);
        return value;
    }

    @Override
    public double numberAbove(double least, double most) throws IOException {
        var allowed = new Expected.NumberAbove(least, most);
        double value = number(allowed);
        if (!(value > least && value <= most)) throw refusals.other(allowed);
        return value;
    }

    @Override
    public InvalidInput invalid(String reason) {
        return refusals.invalid(reason);
    }
}
