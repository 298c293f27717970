package rasterlab.exercises.proving;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.BooleanNode;
import com.fasterxml.jackson.databind.node.DoubleNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;
import rasterlab.exercises.predicting.SheetGrading;
import rasterlab.exercises.predicting.SheetText;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Report;

/**
 * Proves an exercise that asks for the next steps of a method: the steps that it makes earn all
 * points, and a wrong answer to any of them loses its points alone.
 */
final class PredictProving {
    /** Sheets that are tried. */
    private static final int SHEETS = 3;

    private final Exercise exercise;
    private final Predicting rules;
    private final long seed;

    private PredictProving(Exercise exercise, long seed) {
        this.exercise = exercise;
        this.rules = exercise.predicting().orElseThrow();
        this.seed = seed;
    }

    /** The proof without the starter. */
    static Proof of(Exercise exercise, long seed) {
        PredictProving proving = new PredictProving(exercise, seed);
        return new Proof(
                exercise,
                seed,
                List.of(proving.right()),
                proving.kills(),
                Optional.empty(),
                Optional.empty());
    }

    private List<Sheet> sheets() {
        List<Sheet> sheets = new ArrayList<>();
        for (int i = 0; i < SHEETS; i++)
            sheets.add(Sheet.of(exercise.topic(), rules, Math.floorMod(seed + i, Sheet.MOST_SEED)));
        return sheets;
    }

    /** The method's own steps, on all sheets. */
    private RightMethod right() {
        int points = Exercise.MOST_POINTS;
        Set<String> lost = new TreeSet<>();
        for (Sheet sheet : sheets()) {
            Report report = report(sheet, Question::right);
            points = Math.min(points, report.points().accuracy());
            lost.addAll(failed(report));
        }
        return new RightMethod(
                rules.method(), true, points, 0, List.copyOf(lost), List.of(), List.of());
    }

    /** A wrong answer to each step of the sheets; one that costs anything else is not rejected. */
    private List<Kill> kills() {
        List<Sheet> sheets = sheets();
        List<Kill> kills = new ArrayList<>();
        for (Case one : exercise.cases()) {
            boolean alone = sheets.stream().allMatch(sheet -> isLostAlone(sheet, one.name()));
            List<String> cases = alone ? List.of(one.name()) : List.of();
            kills.add(new Kill(one.name(), false, true, cases, cases, List.of(), true));
        }
        return kills;
    }

    private boolean isLostAlone(Sheet sheet, String step) {
        Report report =
                report(
                        sheet,
                        one ->
                                Predicting.step(one.number()).equals(step)
                                        ? wrong(one)
                                        : one.right());
        return failed(report).equals(List.of(step));
    }

    private static List<String> failed(Report report) {
        return report.cases().stream()
                .filter(one -> one.points() < one.of())
                .map(CaseReport::name)
                .toList();
    }

    private Report report(Sheet sheet, Function<Question, JsonNode> answer) {
        String sent = SheetText.written(exercise.id(), sheet, answer);
        return new SheetGrading(exercise, CaseSelection.all(sheet.seed()), done -> {}).report(sent);
    }

    /** The right answer but for its last field. */
    private JsonNode wrong(Question question) {
        ObjectNode answer = question.right();
        PredictedField last = rules.asked().get(rules.asked().size() - 1);
        answer.set(last.field(), other(answer.get(last.field()), last.words()));
        return answer;
    }

    private JsonNode other(JsonNode right, List<String> words) {
        if (right.isBoolean()) return BooleanNode.valueOf(!right.booleanValue());
        if (right.isNumber())
            return new DoubleNode(right.doubleValue() + 2 * rules.tolerance() + 1);
        if (right.isArray()) {
            var changed = JsonNodeFactory.instance.arrayNode();
            right.forEach(one -> changed.add(other(one, words)));
            return changed;
        }
        return words.stream()
                .filter(word -> !word.equals(right.textValue()))
                .findFirst()
                .map(TextNode::valueOf)
                .orElseGet(() -> TextNode.valueOf(right.textValue() + "?"));
    }
}
