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

    private final String place;
    private final JsonNode node;

    private JsonFields(String place, JsonNode node, String... known) {
        this.place = place;
        this.node = node;
        if (!node.isObject()) throw wrong("", "must be an object {…}, got " + shown(node));
        for (Iterator<String> names = node.fieldNames(); names.hasNext(); ) {
            String name = names.next();
            if (known.length > 0 && !List.of(known).contains(name))
                throw wrong(name, "is not known here; known are " + Arrays.toString(known));
        }
    }

    /**
     * Reads an object.
     *
     * @param place what a message calls it, such as "exercise.json"
     * @param known the fields that may occur; none given: any
     */
    public static JsonFields parse(String place, String json, String... known) {
        return new JsonFields(place, tree(place, json), known);
    }

    /** Reads an array of objects, each of which may have the known fields. */
    public static List<JsonFields> parseArray(String place, String json, String... known) {
        JsonNode array = tree(place, json);
        if (!array.isArray())
            throw new CatalogueException(place + " must be an array […], got " + shown(array));
        List<JsonFields> objects = new ArrayList<>();
        for (JsonNode item : array)
            objects.add(new JsonFields(place + "[" + objects.size() + "]", item, known));
        return objects;
    }

    private static JsonNode tree(String place, String json) {
        try {
            return MAPPER.readTree(json);
        } catch (JsonProcessingException e) {
            throw new CatalogueException(place + " is not JSON: " + JsonMistake.in(e), e);
        }
    }

    public boolean has(String field) {
        return node.has(field);
    }

    public JsonFields object(String field, String... known) {
        return new JsonFields(place + ", field '" + field + "'", required(field), known);
    }

    public String text(String field) {
        JsonNode value = required(field);
        if (!value.isTextual() || value.textValue().isBlank())
            throw wrong(field, "must be a text that is not blank, got " + shown(value));
        return value.textValue();
    }

    /** One of the allowed words. */
    public String word(String field, List<String> allowed) {
        String text = text(field);
        if (!allowed.contains(text))
            throw wrong(
                    field, "must be one of " + String.join(", ", allowed) + ", got '" + text + "'");
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
            throw wrong(field, "must be " + wholeNumber(least, most) + ", got " + shown(value));
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
        if (!value.isBoolean()) throw wrong(field, "must be true or false, got " + shown(value));
        return value.booleanValue();
    }

    /** A point [x, y] in pixels. */
    public int[] point(String field) {
        JsonNode value = required(field);
        if (!value.isArray() || value.size() != 2)
            throw wrong(field, "must be a point [x, y], got " + shown(value));
        return new int[] {
            integer(field, value.get(0), Integer.MIN_VALUE, Integer.MAX_VALUE),
            integer(field, value.get(1), Integer.MIN_VALUE, Integer.MAX_VALUE)
        };
    }

    /** So many whole numbers. */
    public int[] integers(String field, int count) {
        JsonNode value = required(field);
        if (!value.isArray() || value.size() != count)
            throw wrong(field, "must have " + count + " whole numbers, got " + shown(value));
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
            throw wrong(field, "must be an array of texts, at least one, got " + shown(value));
        return texts;
    }

    /** The object under that field as JSON text. */
    public String json(String field) {
        JsonNode value = required(field);
        if (!value.isObject()) throw wrong(field, "must be an object {…}, got " + shown(value));
        return value.toString();
    }

    /** An exception that names this place and the field. */
    public CatalogueException wrong(String field, String what) {
        return new CatalogueException(
                place + (field.isEmpty() ? "" : ", field '" + field + "'") + " " + what);
    }

    private JsonNode required(String field) {
        if (!has(field)) throw wrong(field, "is missing");
        return node.get(field);
    }

    private static String shown(JsonNode value) {
        String text = value.isMissingNode() ? "nothing" : value.toString();
        return text.length() <= 60 ? text : text.substring(0, 60) + "…";
    }
}
