package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import rasterlab.exercises.score.Phrase;

/**
 * A value of a JSON text that knows its place; whatever is wrong there is refused with it.
 *
 * <p>Who reads a kind of text says how its places are named and what a refusal is.
 *
 * @param <P> a place of that kind of text
 */
public abstract class JsonPlace<P extends JsonPlace<P>> {
    private static final int SHOWN = 60;

    private static final JsonMapper STRICT =
            JsonMapper.builder()
                    .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                    .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                    .build();

    static final JsonMapper WITH_ENDLESS_NUMBERS =
            STRICT.rebuild().enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS).build();

    private final JsonNode node;

    protected JsonPlace(JsonNode node) {
        this.node = node;
    }

    /** The tree of a text that is JSON, without a field twice and with nothing behind it. */
    protected static JsonNode tree(String json) throws JsonProcessingException {
        return STRICT.readTree(json);
    }

    /** The same with NaN and infinite numbers, so that they can be refused with their place. */
    protected static JsonNode treeWithEndlessNumbers(String json) throws JsonProcessingException {
        return WITH_ENDLESS_NUMBERS.readTree(json);
    }

    /** The place of a field, which need not be there. */
    protected abstract P field(String name, JsonNode value);

    /** The place of a member of this array. */
    protected abstract P member(int index, JsonNode value);

    /** The place of a number of this array, where it stands for one thing such as a point. */
    protected P number(int index, JsonNode value) {
        return member(index, value);
    }

    /** A refusal of this value. */
    protected abstract IllegalArgumentException wrong(Phrase what);

    /** The names of all fields that are known, for a refusal. */
    protected abstract String listed(String... known);

    /** The place that is named where a field is not known. */
    protected P unknown(String name) {
        return at(name);
    }

    /** How an infinite number, or none, is shown. */
    protected String endless() {
        return node.toString();
    }

    /** Passes if this is an object in which only the known fields occur; none given: any. */
    protected final void requireObject(String... known) {
        if (!node.isObject()) throw wrong(Phrase.of("field.object", shown()));
        for (Iterator<String> names = node.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (known.length > 0 && !List.of(known).contains(name))
                throw unknown(name).wrong(Phrase.of("field.unknown", listed(known)));
        }
    }

    public final boolean has(String field) {
        return node.has(field);
    }

    /** The names of the fields of this object; none where it is something else. */
    public final List<String> names() {
        var names = new ArrayList<String>();
        node.fieldNames().forEachRemaining(names::add);
        return names;
    }

    /** A field that must be there: whoever reads it where it is not is refused. */
    public final P at(String field) {
        return field(field, node.path(field));
    }

    /** A field that is there. */
    protected final P required(String field) {
        if (!has(field)) throw at(field).wrong(Phrase.of("field.missing"));
        return at(field);
    }

    public final Optional<P> optional(String field) {
        return has(field) ? Optional.of(at(field)) : Optional.empty();
    }

    public final boolean isObject() {
        return node.isObject();
    }

    public final boolean isArray() {
        return node.isArray();
    }

    public final boolean isText() {
        return node.isTextual();
    }

    public final boolean isNull() {
        return node.isNull();
    }

    /** Whether this is NaN or infinite, for which JSON has no number. */
    public final boolean isEndless() {
        return node.isFloatingPointNumber() && !Double.isFinite(node.doubleValue());
    }

    /** The members of this array. */
    public final List<P> members() {
        if (!node.isArray()) throw wrong(Phrase.of("field.array", shown()));
        List<P> members = new ArrayList<>();
        for (JsonNode each : node) members.add(member(members.size(), each));
        return members;
    }

    public final String text() {
        if (!node.isTextual() || node.textValue().isBlank())
            throw wrong(Phrase.of("field.text", shown()));
        return node.textValue();
    }

    public final boolean flag() {
        if (!node.isBoolean()) throw wrong(Phrase.of("field.flag", shown()));
        return node.booleanValue();
    }

    public final int integer(int least, int most) {
        if (!node.isIntegralNumber()
                || !node.canConvertToInt()
                || node.intValue() < least
                || node.intValue() > most)
            throw wrong(
                    least == most
                            ? Phrase.of("field.only", least, shown())
                            : Phrase.of("field.whole", least, most, shown()));
        return node.intValue();
    }

    /** So many whole numbers; two are a point. */
    protected final int[] integers(int count) {
        if (!node.isArray() || node.size() != count)
            throw wrong(
                    count == 2
                            ? Phrase.of("field.point", shown())
                            : Phrase.of("field.wholes", count, shown()));
        var numbers = new int[count];
        for (int i = 0; i < count; i++)
            numbers[i] = number(i, node.get(i)).integer(Integer.MIN_VALUE, Integer.MAX_VALUE);
        return numbers;
    }

    /** A refusal of a word. */
    protected final IllegalArgumentException notOneOf(List<String> allowed, String word) {
        return wrong(Phrase.of("field.word", String.join(", ", allowed), word));
    }

    public final double number(double least, double most) {
        double value = node.isNumber() ? node.doubleValue() : Double.NaN;
        if (!(value >= least && value <= most))
            throw wrong(
                    Phrase.of(
                            "field.number", String.valueOf(least), String.valueOf(most), shown()));
        return value;
    }

    /**
     * A number that no double holds, as it stands in the text.
     *
     * @param path such as {@code $.camera.rho}
     */
    protected static String endlessNumber(String path, String json) {
        return EndlessNumber.at(path, json);
    }

    /** The value as JSON text. */
    protected final String asJson() {
        return node.toString();
    }

    /** The value for a refusal. */
    protected final Object shown() {
        if (node.isMissingNode()) return Phrase.of("field.nothing");
        return cut(isEndless() ? endless() : node.toString());
    }

    protected static String cut(String text) {
        return text.length() <= SHOWN ? text : text.substring(0, SHOWN) + "…";
    }
}
