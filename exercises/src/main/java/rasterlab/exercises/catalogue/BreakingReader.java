package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Breaking;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.Hint;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.judging.MethodsOnInput;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Message;
import rasterlab.exercises.score.Phrase;

/**
 * Turns the folder of an exercise that asks for inputs on which faulty methods fail into an {@link
 * Exercise} with one case for each of them.
 */
final class BreakingReader {
    /** The text that is handed in where nothing has been found yet. */
    static final String STARTER = "Starter.json";

    private static final int MOST_INPUTS = 20;
    private static final int MOST_CHARACTERS = 60_000;

    private final ExerciseFolder folder;
    private final JsonFields fields;
    private final Faults faults;

    /**
     * @param fields of {@code exercise.json}
     */
    BreakingReader(ExerciseFolder folder, JsonFields fields, Faults faults) {
        this.folder = folder;
        this.fields = fields;
        this.faults = faults;
    }

    /** A faulty method or mutant, and what it pays to break it. */
    private record Target(String name, int points) {}

    /** The exercise; empty where something is wrong, all of which is kept. */
    Optional<Exercise> read() {
        for (String field :
                List.of("tolerance", "points", "caps", "timed", "shapes", "groups", "cases"))
            faults.checked(() -> refuse(field));
        Optional<String> topic = faults.tried(() -> fields.word("topic", Topics.names()));
        Optional<JsonFields> data =
                faults.tried(() -> fields.object("break", "inputs", "size", "targets"));
        Optional<Breaking> breaking = data.flatMap(this::rules);
        List<Target> targets =
                topic.isPresent() && data.isPresent()
                        ? targets(data.get(), topic.get(), breaking)
                        : List.of();
        var titles = ExerciseReader.titles(fields, faults);
        Map<String, String> statements = ExerciseReader.statements(folder, faults);
        var pictures = new StatementPictures(folder, topic).read(statements, faults);
        var starter = faults.tried(() -> folder.text(STARTER));
        var minutes = faults.tried(() -> ExerciseReader.minutes(fields));
        List<Hint> hints = new HintReader(folder, fields, faults).read();
        if (!faults.all().isEmpty()) return Optional.empty();
        return Optional.of(
                new Exercise(
                        folder.id(),
                        topic.orElseThrow(),
                        Optional.empty(),
                        titles.orElseThrow(),
                        statements,
                        pictures,
                        starter.orElseThrow(),
                        Revision.of(folder.read()),
                        new ExerciseTolerance(false),
                        new PointPlan(Exercise.MOST_POINTS, 0, 0),
                        Exercise.StatedLimits.NONE,
                        Optional.empty(),
                        List.of(),
                        cases(topic.get(), targets, breaking.orElseThrow()),
                        breaking,
                        Optional.empty(),
                        new Exercise.Evidence(Optional.empty(), Set.of()),
                        minutes.orElseThrow(),
                        hints));
    }

    private void refuse(String field) {
        if (fields.has(field)) throw fields.wrong(field, Phrase.of("field.not-in-break"));
    }

    /** The rules for inputs; empty where something is wrong, all of which is kept. */
    private Optional<Breaking> rules(JsonFields data) {
        Optional<Integer> inputs = faults.tried(() -> data.integer("inputs", 1, MOST_INPUTS, 1));
        Optional<JsonFields> size =
                faults.tried(() -> data.object("size", "points", "small", "large"));
        if (size.isEmpty()) return Optional.empty();
        JsonFields at = size.get();
        Optional<Integer> points =
                faults.tried(() -> at.integer("points", 0, Exercise.MOST_POINTS - 1));
        Optional<Integer> small = faults.tried(() -> at.integer("small", 1, MOST_CHARACTERS));
        int least = small.orElse(1) + 1;
        Optional<Integer> large =
                faults.tried(() -> at.integer("large", least, 10 * MOST_CHARACTERS));
        return inputs.isPresent() && points.isPresent() && small.isPresent() && large.isPresent()
                ? Optional.of(new Breaking(inputs.get(), points.get(), small.get(), large.get()))
                : Optional.empty();
    }

    private static List<Case> cases(String topic, List<Target> targets, Breaking breaking) {
        List<Case> cases = new ArrayList<>();
        for (Target one : targets)
            cases.add(open(one.name(), titles(topic, one.name()), one.points()));
        cases.add(
                open(
                        Breaking.SIZE,
                        titles(each -> Message.of("case." + Breaking.SIZE)),
                        breaking.sizePoints()));
        return cases;
    }

    private static Case open(String name, Map<String, String> titles, int points) {
        return new Case(name, titles, Criterion.ACCURACY, Disclosure.OPEN, points, "{}", false);
    }

    /** The targets; what is wrong with each is kept, and the sum is asked of right ones alone. */
    private List<Target> targets(JsonFields data, String topic, Optional<Breaking> breaking) {
        List<String> known = MethodsOnInput.breakable(topic);
        Optional<Integer> points = breaking.map(one -> Exercise.MOST_POINTS - one.sizePoints());
        if (!data.has("targets")) return points.map(all -> shared(known, all)).orElse(List.of());
        int before = faults.all().size();
        List<Target> targets = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (JsonFields one :
                faults.tried(() -> data.objects("targets", "name", "points")).orElse(List.of()))
            target(one, known, names).ifPresent(targets::add);
        int sum = targets.stream().mapToInt(Target::points).sum();
        if (faults.all().size() == before && points.filter(all -> all != sum).isPresent())
            faults.checked(
                    () -> {
                        throw data.wrong("targets", Phrase.of("field.targets", sum, points.get()));
                    });
        return targets;
    }

    private Optional<Target> target(JsonFields one, List<String> known, Set<String> names) {
        Optional<String> name = faults.tried(() -> one.word("name", known));
        Optional<Integer> points =
                faults.tried(() -> one.integer("points", 0, Exercise.MOST_POINTS));
        if (name.isEmpty()) return Optional.empty();
        if (!names.add(name.get()))
            faults.checked(
                    () -> {
                        throw one.wrong("name", Phrase.of("field.target.twice", name.get()));
                    });
        return points.map(each -> new Target(name.get(), each));
    }

    /** All alike; the first ones have one point more where that does not come out even. */
    private static List<Target> shared(List<String> names, int points) {
        List<Target> targets = new ArrayList<>();
        for (int i = 0; i < names.size(); i++)
            targets.add(
                    new Target(
                            names.get(i),
                            points / names.size() + (i < points % names.size() ? 1 : 0)));
        return targets;
    }

    /** Names a mutant by its mistake, and a faulty method by its first fault and its name. */
    private static Map<String, String> titles(String topic, String name) {
        String mutant = "mutant." + topic + "." + name;
        if (!Message.isKnown(mutant))
            return titles(
                    language ->
                            Message.of("case.break.method", "fault." + topic + "." + name, name));
        return titles(language -> Message.of("case.break", Message.of(mutant).in(language)));
    }

    private static Map<String, String> titles(Function<String, Message> title) {
        Map<String, String> titles = new LinkedHashMap<>();
        for (String each : List.of("en", "ru")) titles.put(each, title.apply(each).in(each));
        return titles;
    }
}
