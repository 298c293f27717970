package rasterlab.exercises.predicting;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.StreamSupport;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.score.StepWords;

/**
 * Puts steps, answers and inputs of a topic into words of one language, with its signs in numbers.
 */
public final class StepText {
    private static final Pattern MINUS = Pattern.compile("(?<![\\p{L}\\d])-(?=\\d)");

    private static final Pattern POINT = Pattern.compile("(?<=\\d)\\.(?=\\d)");

    /** The separator between a number, or a row of them, and the next, named or not. */
    private static final Pattern BETWEEN =
            Pattern.compile("(?<=[\\d)]), (?=[-(]*\\d|[a-z]\\w* = )");

    private final String topic;
    private final StepWords words;
    private final char comma;

    /** The separator between numbers: a semicolon where they have a decimal comma. */
    private final String apart;

    public StepText(String topic, Locale language) {
        this.topic = topic;
        words = StepWords.in(language);
        comma = DecimalFormatSymbols.getInstance(language).getDecimalSeparator();
        apart = comma == ',' ? "; " : ", ";
    }

    /** The name of a field, in this language and on a sheet. */
    public String label(String field) {
        return words.label(topic, field);
    }

    /** A value that is a word. */
    public String word(String value) {
        return words.word(value);
    }

    /** Fields with their values; one that is a line of a program stands behind a colon. */
    public String fieldsText(JsonNode fields) {
        return signed(
                fields.properties().stream()
                        .map(
                                one ->
                                        label(one.getKey())
                                                + (one.getValue().isTextual() ? ": " : " = ")
                                                + value(one.getValue()))
                        .collect(joining(apart)));
    }

    /** One value, whose own parts have names as it has one. */
    public String value(JsonNode value) {
        if (value.isTextual() || value.isBoolean()) return word(value.asText());
        if (!value.isObject()) return number(value);
        return value.properties().stream()
                .map(one -> label(one.getKey()) + " = " + value(one.getValue()))
                .collect(joining(apart));
    }

    /**
     * The parts of an input, each with its name and value.
     *
     * @param json an object
     */
    public List<String> input(String json) {
        try {
            return OwnJson.MAPPER.readTree(json).properties().stream()
                    .map(one -> signed(part(one.getKey(), one.getValue())))
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A field of an input; rows of letters and of rows stand below each other. */
    public String part(String field, JsonNode value) {
        boolean rows =
                value.isArray()
                        && !value.isEmpty()
                        && (value.get(0).isTextual() || value.get(0).isArray());
        if (!rows) return label(field) + (value.isObject() ? ": " : " = ") + value(value);
        var text = new StringBuilder(label(field)).append(" =");
        value.forEach(row -> text.append("\n      ").append(number(row)));
        return text.toString();
    }

    private String number(JsonNode value) {
        if (value.isArray())
            return StreamSupport.stream(value.spliterator(), false)
                    .map(this::number)
                    .collect(joining(apart, "(", ")"));
        String told = StepValues.valueText(value);
        return value.isNumber() ? told.replace('.', comma) : told;
    }

    /** A sentence that names fields as a sheet does, with the names and words of this language. */
    public String named(String sentence, List<String> fields) {
        String named = sentence;
        for (String field : fields)
            named =
                    Pattern.compile("(?<![\\w(])" + Pattern.quote(field) + " = ([a-z]+\\b)?")
                            .matcher(named)
                            .replaceAll(
                                    found ->
                                            Matcher.quoteReplacement(
                                                    label(field) + " = " + found(found.group(1))));
        return named;
    }

    private String found(String word) {
        return word == null ? "" : word(word);
    }

    /** A sentence whose numbers have points, with the language's comma. */
    public String localised(String sentence) {
        String listed = BETWEEN.matcher(sentence).replaceAll(apart);
        return signed(POINT.matcher(listed).replaceAll(String.valueOf(comma)));
    }

    /** The sentence with a minus as long as digits are wide. */
    public static String signed(String sentence) {
        return MINUS.matcher(sentence).replaceAll("−");
    }
}
