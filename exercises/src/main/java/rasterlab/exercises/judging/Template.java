package rasterlab.exercises.judging;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.IntNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.LongNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
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

    private static final Pattern WHOLE = Pattern.compile("-?\\d+");

    private final Phrase place;
    private final NamedNumbers let;
    private final Part root;

    /** A value of the template, ready to be drawn as often as asked. */
    @FunctionalInterface
    private interface Part {
        JsonNode draw(Random random, Map<String, Long> named);
    }

    /**
     * @param let the numbers that may stand in it by their names
     * @throws CatalogueException if it is no object, or if a range or a number of times cannot be
     */
    Template(Phrase place, JsonNode root, NamedNumbers let) {
        this.place = place;
        this.let = let;
        if (!root.isObject()) throw wrong("template.json", root);
        this.root = part(root);
    }

    /**
     * One input as JSON.
     *
     * @param named the numbers that stand in it by their names
     * @throws CatalogueException if a sum cannot be
     */
    JsonNode draw(Random random, Map<String, Long> named) {
        return root.draw(random, named);
    }

    private Part part(JsonNode node) {
        if (node.isTextual()) return text(node);
        if (node.isArray()) return array(parts(node));
        if (!node.isObject()) return (random, named) -> node;
        if (node.has("any")) return oneOf(node.get("any"));
        if (node.has("times") && node.has("of")) return times(node);
        Map<String, Part> fields = new LinkedHashMap<>();
        node.properties().forEach(field -> fields.put(field.getKey(), part(field.getValue())));
        return (random, named) -> {
            ObjectNode object = JsonNodeFactory.instance.objectNode();
            fields.forEach((name, value) -> object.set(name, value.draw(random, named)));
            return object;
        };
    }

    private List<Part> parts(JsonNode array) {
        List<Part> parts = new ArrayList<>();
        array.forEach(one -> parts.add(part(one)));
        return parts;
    }

    private static Part array(List<Part> parts) {
        return (random, named) -> {
            ArrayNode array = JsonNodeFactory.instance.arrayNode();
            for (Part one : parts) array.add(one.draw(random, named));
            return array;
        };
    }

    private Part oneOf(JsonNode all) {
        if (!all.isArray() || all.isEmpty()) throw wrong("template.any", all);
        List<Part> parts = parts(all);
        return (random, named) -> parts.get(random.nextInt(parts.size())).draw(random, named);
    }

    private Part times(JsonNode node) {
        JsonNode times = node.get("times");
        int count = times.canConvertToInt() && times.isIntegralNumber() ? times.intValue() : 0;
        if (count < 1 || count > MOST_TIMES) throw wrong("template.times", MOST_TIMES, node);
        return array(Collections.nCopies(count, part(node.get("of"))));
    }

    /** A text that is no range stays, such as the name of a rule. */
    private Part text(JsonNode text) {
        String written = text.textValue();
        if (written.startsWith("="))
            return (random, named) -> new LongNode(let.sum(written.substring(1), named));
        Matcher range = RANGE.matcher(written);
        if (!range.matches()) return (random, named) -> text;
        double least = Double.parseDouble(range.group(1));
        double most = Double.parseDouble(range.group(2));
        if (!(least <= most)) throw wrong("template.range", text);
        if (!WHOLE.matcher(range.group(1)).matches() || !WHOLE.matcher(range.group(2)).matches())
            return (random, named) -> new DoubleNode(least + random.nextDouble() * (most - least));
        if (least < Integer.MIN_VALUE || most > Integer.MAX_VALUE)
            throw wrong("template.range", text);
        long count = (long) most - (long) least + 1;
        return (random, named) ->
                new IntNode((int) ((long) least + (long) (random.nextDouble() * count)));
    }

    private CatalogueException wrong(String key, Object... arguments) {
        Object[] shown = new Object[arguments.length];
        for (int i = 0; i < shown.length; i++) shown[i] = String.valueOf(arguments[i]);
        return new CatalogueException(Phrase.of("field.wrong", place, Phrase.of(key, shown)));
    }
}
