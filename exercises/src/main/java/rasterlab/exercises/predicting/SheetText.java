package rasterlab.exercises.predicting;

import static java.util.stream.Collectors.joining;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.Function;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.PredictedField;

/**
 * Writes a sheet as the JSON document that a student completes: the questions, and for each an
 * answer with {@code null} where the student's is to stand.
 */
public final class SheetText {
    private SheetText() {}

    /** A seed for practice, another one at each call. */
    public static long freshSeed() {
        return ThreadLocalRandom.current().nextLong(Sheet.MOST_SEED + 1);
    }

    /**
     * A sheet to be answered.
     *
     * @param exercise one that asks for predictions
     */
    public static String open(Exercise exercise, long seed) {
        Predicting rules = exercise.predicting().orElseThrow();
        return open(exercise.id(), Sheet.of(exercise.topic(), rules, seed));
    }

    /** The text of an exercise that is not read to its end. */
    public static String open(String id, Sheet sheet) {
        return written(id, sheet, question -> JsonNodeFactory.instance.objectNode());
    }

    /** A sheet with these answers; fields that one has not are {@code null}. */
    public static String written(String id, Sheet sheet, Function<Question, JsonNode> answer) {
        return "{\n  \"exercise\": "
                + TextNode.valueOf(id)
                + ",\n  \"seed\": "
                + sheet.seed()
                + ",\n  \"questions\": [\n"
                + rounds(sheet).stream().map(SheetText::question).collect(joining(",\n"))
                + "\n  ],\n  \"answers\": [\n"
                + sheet.questions().stream()
                        .map(one -> "    " + answer(one, answer.apply(one)))
                        .collect(joining(",\n"))
                + "\n  ]\n}\n";
    }

    /** The questions of one walk together. */
    private static List<List<Question>> rounds(Sheet sheet) {
        List<List<Question>> rounds = new ArrayList<>();
        for (Question one : sheet.questions()) {
            if (one.before().size() == one.rules().shown()) rounds.add(new ArrayList<>());
            rounds.get(rounds.size() - 1).add(one);
        }
        return rounds;
    }

    private static String question(List<Question> round) {
        String shown = round.get(0).before().stream().map(SheetText::line).collect(joining(", "));
        return "    {\"input\": "
                + spaced(round.get(0).input())
                + (shown.isEmpty() ? "" : ",\n     \"shown\": [" + shown + "]")
                + ",\n     \"asked\": ["
                + round.stream().map(SheetText::asked).collect(joining(", "))
                + "]}";
    }

    private static String asked(Question one) {
        ObjectNode asked = JsonNodeFactory.instance.objectNode();
        asked.put(HandedAnswers.NUMBER, one.number());
        return line(asked.setAll(one.givenFields()));
    }

    private static String answer(Question one, JsonNode answer) {
        ObjectNode written = JsonNodeFactory.instance.objectNode();
        written.put(HandedAnswers.NUMBER, one.number());
        for (PredictedField each : one.rules().asked()) {
            JsonNode value = answer.path(each.field());
            written.set(
                    each.field(),
                    value.isMissingNode() ? JsonNodeFactory.instance.nullNode() : value);
        }
        return line(written);
    }

    private static String line(JsonNode node) {
        return spaced(node.toString());
    }

    /** The text with spaces between values, and none within texts changed. */
    private static String spaced(String json) {
        StringBuilder text = new StringBuilder();
        boolean quoted = false;
        for (int i = 0; i < json.length(); i++) {
            char c = json.charAt(i);
            if (c == '"' && (i == 0 || json.charAt(i - 1) != '\\')) quoted = !quoted;
            text.append(c);
            if (!quoted && (c == ',' || c == ':')) text.append(' ');
        }
        return text.toString();
    }
}
