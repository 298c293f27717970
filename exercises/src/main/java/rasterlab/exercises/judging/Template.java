package rasterlab.exercises.judging;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * Inputs of a topic as JSON with places that are drawn anew for each: {@code "-40..40"} is a whole
 * number of that range, {@code "0.5..1.0"} any double of it, <code>{"any": [x, y]}</code> one of
 * these, and <code>{"times": 6, "of": x}</code> an array of so many.
 */
final class Template {
    private static final JsonMapper MAPPER = new JsonMapper();
    private static final String NUMBER = "-?\\d+(?:\\.\\d+)?(?:[eE][+-]?\\d+)?";
    private static final Pattern RANGE = Pattern.compile("(" + NUMBER + ")\\.\\.(" + NUMBER + ")");
    private static final int MOST_TIMES = 10_000;

    private final Phrase place;
    private final JsonNode root;

    /**
     * @throws CatalogueException if the text is no JSON
     */
    Template(Phrase place, String json) {
        this.place = place;
        try {
            this.root = MAPPER.readTree(json);
        } catch (JsonProcessingException e) {
            throw wrong("template.json", json);
        }
    }

    /**
     * One input as JSON.
     *
     * @throws CatalogueException if a range or a number of times cannot be
     */
    String draw(Random random) {
        return drawn(root, random).toString();
    }

    private JsonNode drawn(JsonNode node, Random random) {
        if (node.isTextual()) return number(node, random);
        if (node.isArray()) {
            ArrayNode array = MAPPER.createArrayNode();
            for (JsonNode one : node) array.add(drawn(one, random));
            return array;
        }
        if (!node.isObject()) return node;
        if (node.has("any")) return oneOf(node.get("any"), random);
        if (node.has("times")) return times(node, random);
        ObjectNode object = MAPPER.createObjectNode();
        node.properties().forEach(f -> object.set(f.getKey(), drawn(f.getValue(), random)));
        return object;
    }

    private JsonNode oneOf(JsonNode all, Random random) {
        if (!all.isArray() || all.isEmpty()) throw wrong("template.any", all);
        return drawn(all.get(random.nextInt(all.size())), random);
    }

    private JsonNode times(JsonNode node, Random random) {
        JsonNode times = node.get("times");
        int count = times.canConvertToInt() && times.isIntegralNumber() ? times.intValue() : 0;
        if (count < 1 || count > MOST_TIMES || !node.has("of"))
            throw wrong("template.times", MOST_TIMES, node);
        ArrayNode array = MAPPER.createArrayNode();
        for (int left = count; left > 0; left--) array.add(drawn(node.get("of"), random));
        return array;
    }

    /** A text that is no range stays, such as the name of a rule. */
    private JsonNode number(JsonNode text, Random random) {
        Matcher range = RANGE.matcher(text.textValue());
        if (!range.matches()) return text;
        double least = Double.parseDouble(range.group(1));
        double most = Double.parseDouble(range.group(2));
        if (!(least <= most)) throw wrong("template.range", text);
        boolean whole = (range.group(1) + range.group(2)).matches("[-\\d]+");
        if (!whole) return new DoubleNode(least + random.nextDouble() * (most - least));
        long count = (long) most - (long) least + 1;
        if (least < Integer.MIN_VALUE || most > Integer.MAX_VALUE)
            throw wrong("template.range", text);
        return new IntNode((int) ((long) least + (long) (random.nextDouble() * count)));
    }

    private CatalogueException wrong(String key, Object... arguments) {
        Object[] shown = new Object[arguments.length];
        for (int i = 0; i < shown.length; i++) shown[i] = String.valueOf(arguments[i]);
        return new CatalogueException(Phrase.of("field.wrong", place, Phrase.of(key, shown)));
    }
}
