package rasterlab.exercises.json;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * One JSON object of an exercise's data, read strictly: a missing, unknown or out-of-range field is
 * a {@link CatalogueException} that names the place and what is allowed.
 */
public final class JsonFields {
    private static final JsonMapper MAPPER =
            JsonMapper.builder()
                    .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                    .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
                    .build();

    private final Phrase place;
    private final JsonNode node;

    private JsonFields(Phrase place, JsonNode node, String... known) {
        this.place = place;
        this.node = node;
        if (!node.isObject()) throw wrong("", Phrase.of("field.object", shown(node)));
        for (Iterator<String> names = node.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (known.length > 0 && !List.of(known).contains(name))
                throw wrong(name, Phrase.of("field.unknown", Arrays.toString(known)));
        }
    }

    /**
     * Reads an object.
     *
     * @param place what a message calls it, such as "exercise.json"
     * @param known the fields that may occur; none given: any
     */
    public static JsonFields parse(String place, String json, String... known) {
        return parse(Phrase.quoted(place), json, known);
    }

    /** The same where words of ours say the place. */
    public static JsonFields parse(Phrase place, String json, String... known) {
        return new JsonFields(place, tree(place, json), known);
    }

    /** Reads an array of objects, each of which may have the known fields. */
    public static List<JsonFields> parseArray(String file, String json, String... known) {
        Phrase place = Phrase.quoted(file);
        JsonNode array = tree(place, json);
        if (!array.isArray()) throw wrong(place, Phrase.of("field.array", shown(array)), null);
        List<JsonFields> objects = new ArrayList<>();
        for (JsonNode item : array)
            objects.add(
                    new JsonFields(Phrase.quoted(file + "[" + objects.size() + "]"), item, known));
        return objects;
    }

    private static JsonNode tree(Phrase place, String json) {
        try {
            return MAPPER.readTree(json);
        } catch (JsonProcessingException e) {
            throw wrong(place, Phrase.of("json.not", JsonMistake.in(e)), e);
        }
    }

    public boolean has(String field) {
        return node.has(field);
    }

    public JsonFields object(String field, String... known) {
        return new JsonFields(place(field), required(field), known);
    }

    /** An array of objects, each of which may have the known fields; none where it is missing. */
    public List<JsonFields> objects(String field, String... known) {
        if (!has(field)) return List.of();
        JsonNode array = node.get(field);
        if (!array.isArray()) throw wrong(field, Phrase.of("field.array", shown(array)));
        List<JsonFields> objects = new ArrayList<>();
        for (JsonNode item : array)
            objects.add(new JsonFields(place(field + "[" + objects.size() + "]"), item, known));
        return objects;
    }

    public String text(String field) {
        JsonNode value = required(field);
        if (!value.isTextual() || value.textValue().isBlank())
            throw wrong(field, Phrase.of("field.text", shown(value)));
        return value.textValue();
    }

    /** One of the allowed words. */
    public String word(String field, List<String> allowed) {
        String text = text(field);
        if (!allowed.contains(text))
            throw wrong(field, Phrase.of("field.word", String.join(", ", allowed), text));
        return text;
    }

    public int integer(String field, int least, int most) {
        return integer(field, required(field), least, most);
    }

    private int integer(String field, JsonNode value, int least, int most) {
        if (!value.isIntegralNumber()
                || !value.canConvertToInt()
                || value.intValue() < least
                || value.intValue() > most)
            throw wrong(
                    field,
                    least == most
                            ? Phrase.of("field.only", least, shown(value))
                            : Phrase.of("field.whole", least, most, shown(value)));
        return value.intValue();
    }

    /** What is allowed, in words: a range, or the one number. */
    public static String wholeNumber(int least, int most) {
        return least == most
                ? String.valueOf(least)
                : "a whole number from " + least + " to " + most;
    }

    public int integer(String field, int least, int most, int otherwise) {
        return has(field) ? integer(field, least, most) : otherwise;
    }

    public boolean flag(String field, boolean otherwise) {
        if (!has(field)) return otherwise;
        JsonNode value = node.get(field);
        if (!value.isBoolean()) throw wrong(field, Phrase.of("field.flag", shown(value)));
        return value.booleanValue();
    }

    /** A point [x, y] in pixels. */
    public int[] point(String field) {
        JsonNode value = required(field);
        if (!value.isArray() || value.size() != 2)
            throw wrong(field, Phrase.of("field.point", shown(value)));
        return new int[] {
            integer(field, value.get(0), Integer.MIN_VALUE, Integer.MAX_VALUE),
            integer(field, value.get(1), Integer.MIN_VALUE, Integer.MAX_VALUE)
        };
    }

    /** So many whole numbers. */
    public int[] integers(String field, int count) {
        JsonNode value = required(field);
        if (!value.isArray() || value.size() != count)
            throw wrong(field, Phrase.of("field.wholes", count, shown(value)));
        int[] numbers = new int[count];
        for (int i = 0; i < count; i++)
            numbers[i] = integer(field, value.get(i), Integer.MIN_VALUE, Integer.MAX_VALUE);
        return numbers;
    }

    public List<String> texts(String field) {
        JsonNode value = required(field);
        List<String> texts = new ArrayList<>();
        for (JsonNode item : value) if (item.isTextual()) texts.add(item.textValue());
        if (!value.isArray() || texts.isEmpty() || texts.size() != value.size())
            throw wrong(field, Phrase.of("field.texts", shown(value)));
        return texts;
    }

    /** The object under that field as JSON text. */
    public String json(String field) {
        JsonNode value = required(field);
        if (!value.isObject()) throw wrong(field, Phrase.of("field.object", shown(value)));
        return value.toString();
    }

    /** An exception that names this place and the field; with no field this place alone. */
    public CatalogueException wrong(String field, Phrase what) {
        return wrong(field.isEmpty() ? place : place(field), what, null);
    }

    private static CatalogueException wrong(Phrase place, Phrase what, Throwable cause) {
        return new CatalogueException(Phrase.of("field.wrong", place, what), cause);
    }

    private Phrase place(String field) {
        return Phrase.of("field", place, field);
    }

    private JsonNode required(String field) {
        if (!has(field)) throw wrong(field, Phrase.of("field.missing"));
        return node.get(field);
    }

    private static Object shown(JsonNode value) {
        if (value.isMissingNode()) return Phrase.of("field.nothing");
        String text = value.toString();
        return text.length() <= 60 ? text : text.substring(0, 60) + "…";
    }
}
