package rasterlab.exercises.catalogue;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Shape;
import rasterlab.engine.study.Method;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Evidence;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.Hint;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.Asked;
import rasterlab.exercises.Predicting.Reason;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;
import rasterlab.exercises.predicting.SheetText;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Phrase;

/**
 * Turns the folder of an exercise that asks for the next steps of a method into an {@link Exercise}
 * with one case for each step.
 */
final class PredictingReader {
    private static final int MOST_SHOWN = 20;
    private static final Field<Double> TOLERANCE =
            Field.required("tolerance", Shape.number(0, 1e6));
    private static final List<String> LANGUAGES = List.of("en", "ru");

    private final ExerciseFolder folder;
    private final JsonFields fields;
    private final Faults faults;

    /**
     * @param fields of {@code exercise.json}
     */
    PredictingReader(ExerciseFolder folder, JsonFields fields, Faults faults) {
        this.folder = folder;
        this.fields = fields;
        this.faults = faults;
    }

    /** Holds the rules of an exercise and a sheet that they draw. */
    private record Drawn(String topic, Predicting rules, Sheet sheet) {}

    /** The exercise; empty where something is wrong, which is kept. */
    Optional<Exercise> read() {
        for (String field :
                List.of("tolerance", "points", "caps", "timed", "shapes", "groups", "cases"))
            if (fields.has(field))
                faults.checked(
                        () -> {
                            throw fields.wrong(field, Phrase.of("field.not-in-predict"));
                        });
        Optional<Drawn> drawn = faults.tried(this::drawn);
        var titles = ExerciseReader.titles(fields, faults);
        Map<String, String> statements = ExerciseReader.statements(folder, faults);
        var pictures =
                new StatementPictures(folder, drawn.map(Drawn::topic)).read(statements, faults);
        var minutes = faults.tried(() -> ExerciseReader.minutes(fields));
        String revision = Revision.of(folder.read());
        List<Hint> hints = new HintReader(folder, fields, faults).read();
        if (!faults.all().isEmpty()) return Optional.empty();
        Predicting rules = drawn.orElseThrow().rules();
        return Optional.of(
                new Exercise(
                        folder.id(),
                        drawn.get().topic(),
                        Optional.empty(),
                        titles.orElseThrow(),
                        statements,
                        pictures,
                        SheetText.open(folder.id(), drawn.get().sheet()),
                        revision,
                        new Tolerance(false),
                        new PointPlan(Exercise.MOST_POINTS, 0, 0),
                        Exercise.Caps.NONE,
                        Optional.empty(),
                        List.of(),
                        cases(rules.steps()),
                        Optional.empty(),
                        Optional.of(rules),
                        new Evidence(Optional.empty(), Set.of()),
                        minutes.orElseThrow(),
                        hints));
    }

    private Drawn drawn() {
        String topic = fields.word("topic", Topics.names());
        JsonFields data =
                fields.object(
                        "predict",
                        "method",
                        "question",
                        "steps",
                        "shown",
                        "walk",
                        "told",
                        "ask",
                        "tolerance",
                        "reason",
                        "let",
                        "given");
        Predicting rules = rules(topic, data);
        Sheet sheet = Sheet.of(topic, rules, 0);
        sheet.questions().forEach(one -> check(data, one));
        return new Drawn(topic, rules, sheet);
    }

    private static Predicting rules(String topic, JsonFields data) {
        JsonFields walk = data.object("walk", "least", "most");
        int steps = data.integer("steps", Predicting.FEWEST_STEPS, Predicting.MOST_STEPS);
        int least = walk.integer("least", 1, steps);
        JsonFields reason = data.object("reason", "step", "field", "en", "ru");
        return new Predicting(
                data.word(
                        "method",
                        Topics.named(topic).methods().stream().map(Method::name).toList()),
                ExerciseReader.titles(data.object("question", "en", "ru")),
                steps,
                data.integer("shown", 0, MOST_SHOWN, 0),
                least,
                walk.integer("most", least, steps),
                data.has("told") ? data.texts("told") : List.of(),
                asked(data),
                data.has("tolerance") ? data.get(TOLERANCE) : 0,
                new Reason(
                        reason.word("step", List.of("before", "same")).equals("before"),
                        reason.has("field") ? Optional.of(reason.text("field")) : Optional.empty(),
                        ExerciseReader.titles(reason)),
                inputs(data));
    }

    private static List<Asked> asked(JsonFields data) {
        List<Asked> asked = new ArrayList<>();
        for (JsonFields one : data.objects("ask", "field", "words"))
            asked.add(
                    new Asked(
                            one.text("field"), one.has("words") ? one.texts("words") : List.of()));
        if (asked.isEmpty()) throw data.wrong("ask", Phrase.of("field.missing"));
        return asked;
    }

    private static String inputs(JsonFields data) {
        ObjectNode inputs = JsonNodeFactory.instance.objectNode();
        inputs.set("given", data.tree("given"));
        if (data.has("let")) inputs.set("let", data.tree("let"));
        return inputs.toString();
    }

    /** Refuses fields that the steps have not. */
    private static void check(JsonFields data, Question question) {
        List<String> known = new ArrayList<>();
        question.step().fieldNames().forEachRemaining(known::add);
        for (String told : question.rules().told()) require(data, "told", known, told);
        for (Asked asked : question.rules().asked()) {
            require(data, "ask", known, asked.field());
        }
        question.rules().reason().field().ifPresent(one -> require(data, "reason", known, one));
    }

    private static void require(JsonFields data, String place, List<String> known, String field) {
        if (!known.contains(field))
            throw data.wrong(place, Phrase.of("field.word", String.join(", ", known), field));
    }

    /** All alike; the first ones have one point more where that does not come out even. */
    private static List<Case> cases(int steps) {
        List<Case> cases = new ArrayList<>();
        for (int number = 1; number <= steps; number++) {
            int more = number <= Exercise.MOST_POINTS % steps ? 1 : 0;
            Map<String, String> titles = new LinkedHashMap<>();
            for (String each : LANGUAGES)
                titles.put(each, Message.of("case.predict", number).in(each));
            cases.add(
                    new Case(
                            Predicting.step(number),
                            titles,
                            Kind.ACCURACY,
                            Disclosure.OPEN,
                            Exercise.MOST_POINTS / steps + more,
                            "{}",
                            false));
        }
        return cases;
    }
}
