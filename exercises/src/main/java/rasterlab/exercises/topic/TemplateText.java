package rasterlab.exercises.topic;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;

/**
 * Writes inputs, and templates of drawn ones, for people: several of one as {@code 6 × [0..9]}, a
 * sum of named numbers as a formula such as {@code x + a}. A number whose name is a word of its
 * author has a letter instead, which says as much in any language.
 */
final class TemplateText {
    private static final Pattern NAME = Pattern.compile("[a-z][a-zA-Z]*");

    /** Matches a sign between two terms of a sum, not that of the first. */
    private static final Pattern BETWEEN_TERMS = Pattern.compile("(?<=\\w)[-+]");

    /** Matches the sign of a number or letter, not the hyphen within a name. */
    private static final Pattern LEADING = Pattern.compile("(?<!\\w)-(?=\\w)");

    private final JsonNode let;
    private final Map<String, String> letters = new HashMap<>();

    /**
     * @param let the named numbers with their ranges and sums; missing where there are none
     */
    TemplateText(JsonNode let) {
        this.let = let;
        let.fieldNames().forEachRemaining(one -> letters.put(one, one));
        Iterator<String> free =
                "abcdefghijklmnopqrstuvwxyz"
                        .chars()
                        .mapToObj(Character::toString)
                        .filter(one -> !let.has(one))
                        .iterator();
        let.fieldNames()
                .forEachRemaining(
                        one -> {
                            if (one.length() > 1 && free.hasNext()) letters.put(one, free.next());
                        });
    }

    /** The named numbers, and the fields of an input in which they stand. */
    String of(JsonNode input) {
        String numbers =
                let.properties().stream()
                        .map(one -> letters.get(one.getKey()) + ": " + sum(one.getValue().asText()))
                        .collect(joining("; "));
        return Stream.of(numbers, fields(input))
                .filter(told -> !told.isEmpty())
                .collect(joining("; "));
    }

    /** The fields without the brackets around. */
    private String fields(JsonNode input) {
        return input.properties().stream()
                .map(one -> one.getKey() + ": " + value(one.getValue()))
                .collect(joining("; "));
    }

    /** A value, a range such as 0..9, several of one, or what may stand there. */
    private String value(JsonNode value) {
        if (value.has("times"))
            return value.path("times").asText() + " × " + value(value.path("of"));
        if (value.has("any")) return list(value.path("any"), " | ");
        if (value.isArray()) return "[" + list(value, ", ") + "]";
        if (value.isObject()) return fields(value);
        String text = value.asText();
        return value.isTextual() && text.startsWith("=") ? sum(text) : signed(text);
    }

    private String list(JsonNode values, String between) {
        return StreamSupport.stream(values.spliterator(), false)
                .map(this::value)
                .collect(joining(between));
    }

    /** A sum, or a range between two, in the notation of formulas. */
    private String sum(String text) {
        String plain = text.startsWith("=") ? text.substring(1) : text;
        String lettered =
                NAME.matcher(plain)
                        .replaceAll(
                                one ->
                                        Matcher.quoteReplacement(
                                                letters.getOrDefault(one.group(), one.group())));
        String spaced = BETWEEN_TERMS.matcher(lettered).replaceAll(" $0 ");
        return signed(spaced.replace(" - ", " − ").replace("*", "·").replace("%", " mod "));
    }

    private static String signed(String text) {
        return LEADING.matcher(text).replaceAll("−");
    }
}
