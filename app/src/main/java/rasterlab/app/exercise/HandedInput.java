package rasterlab.app.exercise;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import rasterlab.app.outcome.KeptJson;
import rasterlab.exercises.Exercise;

/** Puts an input from a lab among those that a student hands in to break methods. */
public final class HandedInput {
    private HandedInput() {}

    /**
     * Adds that input as the last one to be handed in: those before stay as far as the exercise
     * takes so many, and the first ones go. A starter, and what is no JSON, gives way.
     *
     * @param source handed in so far
     * @param json the further input
     */
    static String added(Exercise exercise, String source, String json) {
        List<String> inputs = new ArrayList<>();
        if (!source.equals(exercise.starter())) inputs.addAll(inputs(source));
        inputs.removeIf(each -> inputs(each).equals(inputs(json)));
        inputs.add(json);
        int most = exercise.breaking().map(rules -> rules.inputs()).orElse(1);
        List<String> last = inputs.subList(Math.max(0, inputs.size() - most), inputs.size());
        return last.size() == 1
                ? last.get(0)
                : last.stream().collect(Collectors.joining(",\n  ", "[\n  ", "\n]"));
    }

    /** Returns the new source: a lab's input beside those before, or a whole sheet of answers. */
    static String taken(Exercise exercise, String source, String json) {
        return exercise.form() == Exercise.TaskKind.BREAK ? added(exercise, source, json) : json;
    }

    private static List<String> inputs(String source) {
        try {
            JsonNode told = KeptJson.MAPPER.readTree(source);
            List<String> inputs = new ArrayList<>();
            if (told.isArray()) told.forEach(each -> inputs.add(each.toString()));
            else if (told.isObject()) inputs.add(told.toString());
            return inputs;
        } catch (JsonProcessingException noJson) {
            return List.of();
        }
    }

    /** The last input of what is handed in; "" where there is none. */
    public static String last(String source) {
        List<String> inputs = inputs(source);
        return inputs.isEmpty() ? "" : inputs.get(inputs.size() - 1);
    }
}
