package rasterlab.app.practice;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.text.DecimalFormatSymbols;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.StreamSupport;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.Asked;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.predicting.StepValues;

/** Tells in words what the picture shows: the input, and the steps that are made. */
final class WalkText {
    private static final Pattern MINUS = Pattern.compile("(?<![\\p{L}\\d])-(?=\\d)");

    private static final Pattern POINT = Pattern.compile("(?<=\\d)\\.(?=\\d)");

    /** What stands between a number, or a row of them, and the next, named or not. */
    private static final Pattern BETWEEN =
            Pattern.compile("(?<=[\\d)]), (?=[-(]*\\d|[a-z]\\w* = )");

    private WalkText() {}

    /** The input of a walk as JSON. */
    static JsonNode input(String json) {
        try {
            return OwnJson.MAPPER.readTree(json);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A line for each part of the input, and one for each step. */
    static String of(PracticeState state, Texts texts) {
        String topic = state.topic().orElseThrow();
        var text = new StringBuilder(texts.text("walk.input"));
        input(state.question().input())
                .properties()
                .forEach(
                        one ->
                                text.append("\n  ")
                                        .append(part(one.getKey(), one.getValue(), topic, texts)));
        text.append("\n\n").append(texts.text("walk.steps"));
        Predicting rules = state.question().rules();
        for (int i = 0; i < state.steps().size(); i++)
            text.append("\n  ")
                    .append(i + 1)
                    .append(".  ")
                    .append(told(fields(state.steps().get(i), rules), topic, texts));
        if (state.steps().isEmpty()) text.append("\n  ").append(texts.text("walk.none"));
        return signed(text.toString());
    }

    /** The fields of a question; one that is a line of a program stands behind a colon. */
    static String told(JsonNode fields, String topic, Texts texts) {
        return signed(
                fields.properties().stream()
                        .map(
                                one ->
                                        AnswerForm.label(texts, topic, one.getKey())
                                                + (one.getValue().isTextual() ? ": " : " = ")
                                                + value(one.getValue(), texts))
                        .collect(joining(Shown.apart(texts.locale()))));
    }

    private static String value(JsonNode value, Texts texts) {
        return value.isTextual() || value.isBoolean()
                ? AnswerForm.word(texts, value.asText())
                : number(value, texts.locale());
    }

    /** A value of the data, whose own parts have names as it has one. */
    private static String value(JsonNode value, String topic, Texts texts) {
        if (!value.isObject()) return value(value, texts);
        return value.properties().stream()
                .map(
                        one ->
                                AnswerForm.label(texts, topic, one.getKey())
                                        + " = "
                                        + value(one.getValue(), topic, texts))
                .collect(joining(Shown.apart(texts.locale())));
    }

    /** Numbers with the language's comma, and what then stands between them. */
    private static String number(JsonNode value, Locale locale) {
        if (value.isArray())
            return StreamSupport.stream(value.spliterator(), false)
                    .map(one -> number(one, locale))
                    .collect(joining(Shown.apart(locale), "(", ")"));
        String told = StepValues.told(value);
        char comma = DecimalFormatSymbols.getInstance(locale).getDecimalSeparator();
        return value.isNumber() ? told.replace('.', comma) : told;
    }

    /** A sentence that names fields as a sheet does, with the form's names and words. */
    static String named(String words, List<String> fields, String topic, Texts texts) {
        String named = words;
        for (String field : fields) {
            String label = AnswerForm.label(texts, topic, field);
            named =
                    Pattern.compile("(?<![\\w(])" + Pattern.quote(field) + " = ([a-z]+\\b)?")
                            .matcher(named)
                            .replaceAll(
                                    found ->
                                            Matcher.quoteReplacement(
                                                    label + " = " + word(found.group(1), texts)));
        }
        return named;
    }

    private static String word(String found, Texts texts) {
        return found == null ? "" : AnswerForm.word(texts, found);
    }

    /** A sentence whose numbers have points, with the language's comma. */
    static String localised(String words, Locale locale) {
        String apart = Shown.apart(locale);
        char comma = DecimalFormatSymbols.getInstance(locale).getDecimalSeparator();
        String listed = BETWEEN.matcher(words).replaceAll(apart);
        return signed(POINT.matcher(listed).replaceAll(String.valueOf(comma)));
    }

    /** The same with a minus as long as the rulers have it. */
    static String signed(String words) {
        return MINUS.matcher(words).replaceAll("−");
    }

    /** Rows of letters and of rows stand below each other. */
    private static String part(String field, JsonNode value, String topic, Texts texts) {
        String name = AnswerForm.label(texts, topic, field);
        boolean rows =
                value.isArray()
                        && !value.isEmpty()
                        && (value.get(0).isTextual() || value.get(0).isArray());
        if (!rows) return name + (value.isObject() ? ": " : " = ") + value(value, topic, texts);
        var text = new StringBuilder(name).append(" =");
        StreamSupport.stream(value.spliterator(), false)
                .forEach(row -> text.append("\n      ").append(number(row, texts.locale())));
        return text.toString();
    }

    /** What a question tells and asks of a step, without what decides on it. */
    private static ObjectNode fields(JsonNode step, Predicting rules) {
        ObjectNode shown = JsonNodeFactory.instance.objectNode();
        for (String field : rules.told()) shown.set(field, step.path(field));
        for (Asked one : rules.asked()) shown.set(one.field(), step.path(one.field()));
        return shown;
    }
}
