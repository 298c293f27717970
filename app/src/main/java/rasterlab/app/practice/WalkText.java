package rasterlab.app.practice;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.regex.Pattern;
import java.util.stream.StreamSupport;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.Asked;
import rasterlab.exercises.document.OwnJson;
import rasterlab.exercises.predicting.Values;

/** Tells in words what the picture shows: the input, and the steps that are made. */
final class WalkText {
    private static final Pattern MINUS = Pattern.compile("(?<![\\p{L}\\d])-(?=\\d)");

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
        var text = new StringBuilder(texts.text("walk.input"));
        input(state.question().input())
                .properties()
                .forEach(one -> text.append("\n  ").append(part(one.getKey(), one.getValue())));
        text.append("\n\n").append(texts.text("walk.steps"));
        Predicting rules = state.question().rules();
        for (int i = 0; i < state.steps().size(); i++)
            text.append("\n  ")
                    .append(i + 1)
                    .append(".  ")
                    .append(told(fields(state.steps().get(i), rules)));
        if (state.steps().isEmpty()) text.append("\n  ").append(texts.text("walk.none"));
        return signed(text.toString());
    }

    /** The fields of a question; one that is a line of a program stands behind a colon. */
    static String told(JsonNode fields) {
        return signed(
                fields.properties().stream()
                        .map(
                                one ->
                                        one.getKey()
                                                + (one.getValue().isTextual() ? ": " : " = ")
                                                + Values.told(one.getValue()))
                        .collect(joining(", ")));
    }

    /** The same with a minus as long as the rulers have it. */
    static String signed(String words) {
        return MINUS.matcher(words).replaceAll("−");
    }

    /** Rows of letters and of rows stand below each other. */
    private static String part(String name, JsonNode value) {
        boolean rows =
                value.isArray()
                        && !value.isEmpty()
                        && (value.get(0).isTextual() || value.get(0).isArray());
        if (!rows) return name + " = " + Values.told(value);
        var text = new StringBuilder(name).append(" =");
        StreamSupport.stream(value.spliterator(), false)
                .forEach(row -> text.append("\n      ").append(Values.told(row)));
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
