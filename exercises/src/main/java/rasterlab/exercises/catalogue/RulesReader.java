package rasterlab.exercises.catalogue;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Shape;
import rasterlab.engine.study.Method;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.DecisionValue;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/** Reads the object {@code predict}, keeping all that is wrong in it. */
final class RulesReader {
    private static final int MOST_SHOWN = 20;
    private static final Field<Double> TOLERANCE =
            Field.required("tolerance", Shape.number(0, 1e6));

    private final JsonFields data;
    private final Faults faults;

    RulesReader(JsonFields data, Faults faults) {
        this.data = data;
        this.faults = faults;
    }

    /** The bounds of the steps of one walk. */
    private record Lengths(int least, int most) {}

    /**
     * The rules; empty where something is wrong.
     *
     * @param topic whose methods there are; empty where it is unknown
     */
    Optional<Predicting> read(Optional<String> topic) {
        int before = faults.all().size();
        var method = topic.flatMap(one -> faults.tried(() -> data.word("method", methods(one))));
        var question = texts("question");
        var steps =
                faults.tried(
                        () ->
                                data.integer(
                                        "steps", Predicting.FEWEST_STEPS, Predicting.MOST_STEPS));
        var shown = faults.tried(() -> data.integer("shown", 0, MOST_SHOWN, 0));
        var lengths = lengths(steps.orElse(Predicting.MOST_STEPS));
        var told = faults.tried(() -> data.has("told") ? data.texts("told") : List.<String>of());
        List<PredictedField> asked = asked();
        var tolerance = faults.tried(() -> data.has("tolerance") ? data.get(TOLERANCE) : 0.0);
        var unit = data.has("unit") ? texts("unit") : Optional.of(Map.<String, String>of());
        var reason = reason();
        var inputs = faults.tried(this::inputs);
        if (before < faults.all().size() || method.isEmpty()) return Optional.empty();
        return Optional.of(
                new Predicting(
                        method.get(),
                        question.orElseThrow(),
                        steps.orElseThrow(),
                        shown.orElseThrow(),
                        lengths.orElseThrow().least(),
                        lengths.get().most(),
                        told.orElseThrow(),
                        asked,
                        tolerance.orElseThrow(),
                        unit.orElseThrow(),
                        reason.orElseThrow(),
                        inputs.orElseThrow()));
    }

    private static List<String> methods(String topic) {
        return Topics.named(topic).methods().stream().map(Method::name).toList();
    }

    private Optional<Map<String, String>> texts(String field) {
        return faults.tried(() -> data.object(field, "en", "ru"))
                .flatMap(all -> ExerciseReader.texts(all, faults));
    }

    private Optional<Lengths> lengths(int steps) {
        return faults.tried(() -> data.object("walk", "least", "most"))
                .flatMap(
                        walk -> {
                            var least = faults.tried(() -> walk.integer("least", 1, steps));
                            int from = least.orElse(1);
                            var most = faults.tried(() -> walk.integer("most", from, steps));
                            return least.flatMap(a -> most.map(b -> new Lengths(a, b)));
                        });
    }

    private List<PredictedField> asked() {
        List<PredictedField> asked = new ArrayList<>();
        List<JsonFields> given =
                faults.tried(() -> data.objects("ask", "field", "words")).orElse(List.of());
        if (given.isEmpty()) faults.keep(data.wrong("ask", Phrase.of("field.missing")));
        for (JsonFields one : given) {
            var field = faults.tried(() -> one.text("field"));
            var words =
                    faults.tried(() -> one.has("words") ? one.texts("words") : List.<String>of());
            field.ifPresent(
                    name -> words.ifPresent(all -> asked.add(new PredictedField(name, all))));
        }
        return asked;
    }

    private Optional<DecisionValue> reason() {
        return faults.tried(() -> data.object("reason", "step", "field", "en", "ru"))
                .flatMap(this::reason);
    }

    private Optional<DecisionValue> reason(JsonFields all) {
        var step = faults.tried(() -> all.word("step", List.of("before", "same")));
        Optional<String> field =
                all.has("field") ? faults.tried(() -> all.text("field")) : Optional.empty();
        var texts = ExerciseReader.texts(all, faults);
        return step.flatMap(
                one -> texts.map(in -> new DecisionValue(one.equals("before"), field, in)));
    }

    private String inputs() {
        ObjectNode inputs = JsonNodeFactory.instance.objectNode();
        inputs.set("given", data.tree("given"));
        if (data.has("let")) inputs.set("let", data.tree("let"));
        return inputs.toString();
    }
}
