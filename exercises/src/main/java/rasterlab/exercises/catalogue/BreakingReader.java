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
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.Exercise.Tolerance;
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
    /** What is handed in where nothing has been found yet. */
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

    Exercise read() {
        for (String field :
                List.of("tolerance", "points", "caps", "timed", "shapes", "groups", "cases"))
            if (fields.has(field)) throw fields.wrong(field, Phrase.of("field.not-in-break"));
        String topic = fields.word("topic", Topics.names());
        JsonFields data = fields.object("break", "inputs", "size", "targets");
        JsonFields size = data.object("size", "points", "small", "large");
        int small = size.integer("small", 1, MOST_CHARACTERS);
        Breaking breaking =
                new Breaking(
                        data.integer("inputs", 1, MOST_INPUTS, 1),
                        size.integer("points", 0, Exercise.MOST_POINTS - 1),
                        small,
                        size.integer("large", small + 1, 10 * MOST_CHARACTERS));
        List<Case> cases = new ArrayList<>();
        for (Target one : targets(data, topic, Exercise.MOST_POINTS - breaking.sizePoints()))
            cases.add(open(one.name(), titles(topic, one.name()), one.points()));
        cases.add(
                open(
                        Breaking.SIZE,
                        titles(each -> Message.of("case." + Breaking.SIZE)),
                        breaking.sizePoints()));
        Map<String, String> statements = ExerciseReader.statements(folder);
        return new Exercise(
                folder.id(),
                topic,
                Optional.empty(),
                ExerciseReader.titles(fields.object("title", "en", "ru")),
                statements,
                new StatementPictures(folder, topic).read(statements),
                folder.text(STARTER),
                Revision.of(folder.read()),
                new Tolerance(false),
                new PointPlan(Exercise.MOST_POINTS, 0, 0),
                Exercise.Caps.NONE,
                Optional.empty(),
                List.of(),
                cases,
                Optional.of(breaking),
                Optional.empty(),
                new Exercise.Evidence(Optional.empty(), Set.of()),
                ExerciseReader.minutes(fields),
                new HintReader(folder, fields, faults).read());
    }

    private static Case open(String name, Map<String, String> titles, int points) {
        return new Case(name, titles, Kind.ACCURACY, Disclosure.OPEN, points, "{}", false);
    }

    private static List<Target> targets(JsonFields data, String topic, int points) {
        List<String> known = MethodsOnInput.breakable(topic);
        if (!data.has("targets")) return shared(known, points);
        List<Target> targets = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (JsonFields one : data.objects("targets", "name", "points")) {
            String name = one.word("name", known);
            if (!names.add(name)) throw one.wrong("name", Phrase.of("field.target.twice", name));
            targets.add(new Target(name, one.integer("points", 0, Exercise.MOST_POINTS)));
        }
        int sum = targets.stream().mapToInt(Target::points).sum();
        if (sum != points) throw data.wrong("targets", Phrase.of("field.targets", sum, points));
        return targets;
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

    /** A mutant by its mistake, a faulty method by its name. */
    private static Map<String, String> titles(String topic, String name) {
        String key = "mutant." + topic + "." + name;
        return titles(
                language ->
                        Message.of(
                                "case.break",
                                Message.isKnown(key) ? Message.of(key).in(language) : name));
    }

    private static Map<String, String> titles(Function<String, Message> title) {
        Map<String, String> titles = new LinkedHashMap<>();
        for (String each : List.of("en", "ru")) titles.put(each, title.apply(each).in(each));
        return titles;
    }
}
