package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.score.Phrase;

/**
 * Inputs of a topic as JSON with places that are drawn anew for each: {@code "-40..40"} is a whole
 * number of that range, {@code "0.5..1.0"} any double of it, <code>{"any": [x, y]}</code> one of
 * these, <code>{"times": 6, "of": x}</code> an array of so many, and {@code "=x+along"} a sum of
 * {@link NamedNumbers}.
 */
final class Template {
    private static final String NUMBER = "-?\\d+(?:\\.\\d+)?(?:[eE][+-]?\\d+)?";
    private static final Pattern RANGE = Pattern.compile("(" + NUMBER + ")\\.\\.(" + NUMBER + ")");
    private static final int MOST_TIMES = 10_000;

    private final Phrase place;
    private final JsonNode root;
    private final NamedNumbers let;

    /**
     * @param let the numbers that may stand in it by their names
     */
    Template(Phrase place, JsonNode root, NamedNumbers let) {
        this.place = place;
        this.root = root;
        this.let = let;
        if (!root.isObject()) throw wrong("template.json", root);
    }

    /**
     * One input as JSON.
     *
     * @param named the numbers that stand in it by their names
     * @throws CatalogueException if a range, a sum or a number of times cannot be
     */
    JsonNode draw(Random random, Map<String, Long> named) {
        return drawn(root, random, named);
    }

    private JsonNode drawn(JsonNode node, Random random, Map<String, Long> named) {
        if (node.isTextual()) return number(node, random, named);
        if (node.isArray()) {
            ArrayNode array = JsonNodeFactory.instance.arrayNode();
            for (JsonNode one : node) array.add(drawn(one, random, named));
            return array;
        }
        if (!node.isObject()) return node;
        if (node.has("any")) return oneOf(node.get("any"), random, named);
        if (node.has("times") && node.has("of")) return times(node, random, named);
        ObjectNode object = JsonNodeFactory.instance.objectNode();
        node.properties().forEach(f -> object.set(f.getKey(), drawn(f.getValue(), random, named)));
        return object;
    }

    private JsonNode oneOf(JsonNode all, Random random, Map<String, Long> named) {
        if (!all.isArray() || all.isEmpty()) throw wrong("template.any", all);
        return drawn(all.get(random.nextInt(all.size())), random, named);
    }

    private JsonNode times(JsonNode node, Random random, Map<String, Long> named) {
        JsonNode times = node.get("times");
        int count = times.canConvertToInt() && times.isIntegralNumber() ? times.intValue() : 0;
        if (count < 1 || count > MOST_TIMES) throw wrong("template.times", MOST_TIMES, node);
        ArrayNode array = JsonNodeFactory.instance.arrayNode();
        for (int left = count; left > 0; left--) array.add(drawn(node.get("of"), random, named));
        return array;
    }

    /** A text that is no range stays, such as the name of a rule. */
    private JsonNode number(JsonNode text, Random random, Map<String, Long> named) {
        if (text.textValue().startsWith("="))
            return new LongNode(let.sum(text.textValue().substring(1), named));
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
