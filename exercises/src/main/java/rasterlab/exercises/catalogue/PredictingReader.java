package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.Evidence;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.Hint;
import rasterlab.exercises.Predicting;
import rasterlab.exercises.Predicting.PredictedField;
import rasterlab.exercises.json.Faults;
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

    /** The exercise; empty where something is wrong, all of which is kept. */
    Optional<Exercise> read() {
        for (String field :
                List.of("tolerance", "points", "caps", "timed", "shapes", "groups", "cases"))
            if (fields.has(field))
                faults.checked(
                        () -> {
                            throw fields.wrong(field, Phrase.of("field.not-in-predict"));
                        });
        Optional<Drawn> drawn = drawn();
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
                        new ExerciseTolerance(false),
                        new PointPlan(Exercise.MOST_POINTS, 0, 0),
                        Exercise.StatedLimits.NONE,
                        Optional.empty(),
                        List.of(),
                        cases(rules.steps()),
                        Optional.empty(),
                        Optional.of(rules),
                        new Evidence(Optional.empty(), Set.of()),
                        minutes.orElseThrow(),
                        hints));
    }

    /** The rules and a sheet; empty where something is wrong, all of which is kept. */
    private Optional<Drawn> drawn() {
        Optional<String> topic = faults.tried(() -> fields.word("topic", Topics.names()));
        Optional<JsonFields> data =
                faults.tried(
                        () ->
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
                                        "unit",
                                        "reason",
                                        "let",
                                        "given"));
        if (data.isEmpty()) return Optional.empty();
        Optional<Predicting> rules = new RulesReader(data.get(), faults).read(topic);
        if (topic.isEmpty() || rules.isEmpty()) return Optional.empty();
        return faults.tried(() -> Sheet.of(topic.get(), rules.get(), 0))
                .map(sheet -> checked(data.get(), new Drawn(topic.get(), rules.get(), sheet)));
    }

    private Drawn checked(JsonFields data, Drawn drawn) {
        drawn.sheet().questions().forEach(one -> check(data, one));
        return drawn;
    }

    /** Keeps fields that the steps have not. */
    private void check(JsonFields data, Question question) {
        List<String> known = new ArrayList<>();
        question.step().fieldNames().forEachRemaining(known::add);
        for (String told : question.rules().givenFields()) check(data, "told", known, told);
        for (PredictedField asked : question.rules().asked())
            check(data, "ask", known, asked.field());
        question.rules().reason().field().ifPresent(one -> check(data, "reason", known, one));
    }

    private void check(JsonFields data, String place, List<String> known, String field) {
        if (!known.contains(field))
            faults.keep(
                    data.wrong(place, Phrase.of("field.word", String.join(", ", known), field)));
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
                            Criterion.ACCURACY,
                            Disclosure.OPEN,
                            Exercise.MOST_POINTS / steps + more,
                            "{}",
                            false));
        }
        return cases;
    }
}
