package rasterlab.exercises.predicting;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.range.Bounds;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.score.Message;

/**
 * One step that is to be predicted.
 *
 * @param number in the sheet, from 1
 * @param input of the walk, a JSON object
 * @param before the steps of the walk before this one
 * @param step the right one, with all its fields
 */
public record Question(
        Predicting rules, int number, String input, List<JsonNode> before, JsonNode step) {
    public Question {
        Bounds.requireAtLeast("number", number, 1);
        before = List.copyOf(before);
    }

    /** The fields that stand in the question. */
    public ObjectNode givenFields() {
        return part(rules.givenFields());
    }

    /** The right answer. */
    public ObjectNode right() {
        return part(rules.asked().stream().map(PredictedField::field).toList());
    }

    /** The question about a step, without the value that decides on it. */
    public ObjectNode shown(JsonNode step) {
        ObjectNode shown = part(step, rules.givenFields());
        return shown.setAll(part(step, rules.asked().stream().map(PredictedField::field).toList()));
    }

    private ObjectNode part(List<String> fields) {
        return part(step, fields);
    }

    private static ObjectNode part(JsonNode step, List<String> fields) {
        ObjectNode part = JsonNodeFactory.instance.objectNode();
        for (String field : fields) part.set(field, step.path(field));
        return part;
    }

    /** The value by which the method decided; empty where it has none. */
    public Optional<JsonNode> reason() {
        if (rules.reason().before() && before.isEmpty()) return Optional.empty();
        JsonNode has = rules.reason().before() ? before.get(before.size() - 1) : step;
        return rules.reason()
                .field()
                .map(has::path)
                .filter(value -> !value.isMissingNode() && !value.isNull());
    }

    /** Whether nothing is answered, or not all of it. */
    public boolean isOpen(JsonNode answer) {
        return rules.asked().stream().anyMatch(one -> isNothing(answer.path(one.field())));
    }

    private static boolean isNothing(JsonNode value) {
        return value.isMissingNode() || value.isNull();
    }

    public boolean isRight(JsonNode answer) {
        return isRight(answer, 0);
    }

    /**
     * Whether an answer is right that was given less exactly, such as by a click in a picture.
     *
     * @param tolerance the largest error of a number, where that is more than the rules have
     */
    public boolean isRight(JsonNode answer, double tolerance) {
        return !isOpen(answer)
                && StepValues.same(right(), answer, Math.max(tolerance, rules.tolerance()));
    }

    /** The verdict on an answer in words: what was answered, what is right, and why. */
    public Message verdictMessage(JsonNode answer) {
        String right = StepValues.valueText(right());
        Message verdict =
                isOpen(answer)
                        ? Message.of("predict.open", right)
                        : isRight(answer)
                                ? Message.of("predict.right", right)
                                : Message.of("predict.wrong", answered(answer), right);
        return verdict.and(why());
    }

    private String answered(JsonNode answer) {
        ObjectNode part = JsonNodeFactory.instance.objectNode();
        for (PredictedField one : rules.asked()) part.set(one.field(), answer.path(one.field()));
        return StepValues.valueText(part);
    }

    /** The decision on the step, with the value where there is one. */
    public Message why() {
        String english = rules.reason().words("en");
        String russian = rules.reason().words("ru");
        return reason().map(
                        value ->
                                Message.of(
                                        "predict.why",
                                        english,
                                        russian,
                                        StepValues.valueText(value)))
                .orElseGet(() -> Message.of("in-both-languages", english, russian));
    }
}
