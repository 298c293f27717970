package rasterlab.exercises.catalogue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Shape;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Caps;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.Exercise.Group;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Turns an exercise folder into an {@link Exercise}, or says which field of which file is wrong.
 */
final class ExerciseReader {
    private static final List<String> LANGUAGES = List.of("en", "ru");
    private static final String[] CASE_FIELDS = {
        "name", "title", "group", "kind", "visibility", "points", "input", "generate"
    };

    private static final Field<Double> WORST =
            Field.required("worst", Shape.number(0, Double.MAX_VALUE));

    private static final Field<Double> SECONDS =
            Field.required("seconds", Shape.number(Caps.LEAST_SECONDS, Caps.MOST_SECONDS));

    private static final List<String> FORMS = Stream.of(Form.values()).map(Form::code).toList();

    private final ExerciseFolder folder;

    ExerciseReader(ExerciseFolder folder) {
        this.folder = folder;
    }

    Exercise read() {
        String id = folder.id();
        if (!id.matches("[a-z0-9]+(-[a-z0-9]+)*"))
            throw new CatalogueException(Phrase.of("folder.words", id));
        String file = "exercise.json";
        JsonFields fields =
                JsonFields.parse(
                        folder.place(file),
                        folder.text(file),
                        "kind",
                        "topic",
                        "title",
                        "tolerance",
                        "points",
                        "caps",
                        "timed",
                        "shapes",
                        "groups",
                        "cases",
                        "break");
        if (fields.word("kind", FORMS, FORMS.get(0)).equals(Form.BREAK.code()))
            return new BreakingReader(folder, fields).read();
        TopicGrading topic = TopicGradings.named(fields.word("topic", TopicGradings.names()));
        PointPlan points = points(fields.object("points", "accuracy", "stability", "speed"));
        List<Group> groups = GroupReader.read(fields, topic);
        Shapes shapes = Shapes.read(fields);
        List<Case> cases = new ArrayList<>();
        for (String caseFile : fields.texts("cases"))
            cases.addAll(cases(caseFile, topic, GroupReader.names(groups), shapes));
        checkNames(cases);
        checkSum(cases, Kind.ACCURACY, points.accuracy());
        checkSum(cases, Kind.STABILITY, points.stability());
        Map<String, String> statements = statements(folder);
        Exercise read =
                new Exercise(
                        id,
                        topic.name(),
                        titles(fields.object("title", "en", "ru")),
                        statements,
                        new StatementPictures(folder).read(statements),
                        folder.text("Starter.java"),
                        Revision.of(folder.read()),
                        tolerance(
                                fields.object("tolerance", "eitherPixelOnTies", "worst", "unit"),
                                topic),
                        points,
                        fields.has("caps")
                                ? caps(fields.object("caps", "items", "bytes", "seconds"))
                                : Exercise.Caps.NONE,
                        fields.has("timed") ? Optional.of(fields.json("timed")) : Optional.empty(),
                        groups,
                        cases,
                        Optional.empty());
        checkItems(read, topic);
        checkTimings(fields, topic, read);
        return read;
    }

    /** Asks for inputs to measure speed on, so that a mistake shows before anybody submits. */
    private static void checkTimings(JsonFields fields, TopicGrading topic, Exercise read) {
        try {
            topic.timings(read, new Random(0), List.of());
        } catch (CatalogueException e) {
            throw fields.wrong("", Phrase.of("field.unusable", e.said()));
        }
    }

    /** An error is stated with its unit, so that nobody takes pixels for shares. */
    private static Tolerance tolerance(JsonFields fields, TopicGrading topic) {
        boolean either = fields.flag("eitherPixelOnTies", false);
        if (!fields.has("worst") && !fields.has("unit")) return new Tolerance(either);
        if (topic.unit().isEmpty()) throw fields.wrong("worst", Phrase.of("field.no-tolerance"));
        fields.word("unit", List.of(topic.unit().get()));
        return new Tolerance(either, OptionalDouble.of(fields.get(WORST)));
    }

    private static Caps caps(JsonFields fields) {
        return new Caps(
                whole(fields, "items", Caps.MOST_ITEMS),
                whole(fields, "bytes", Caps.MOST_BYTES),
                fields.has("seconds")
                        ? Optional.of(Duration.ofNanos(Math.round(fields.get(SECONDS) * 1e9)))
                        : Optional.empty());
    }

    private static OptionalInt whole(JsonFields fields, String field, int most) {
        return fields.has(field)
                ? OptionalInt.of(fields.integer(field, 1, most))
                : OptionalInt.empty();
    }

    static Map<String, String> titles(JsonFields fields) {
        Map<String, String> titles = new LinkedHashMap<>();
        for (String language : LANGUAGES) titles.put(language, fields.text(language));
        return titles;
    }

    static Map<String, String> statements(ExerciseFolder folder) {
        Map<String, String> statements = new LinkedHashMap<>();
        for (String language : LANGUAGES)
            statements.put(language, folder.text(StatementPictures.file(language)));
        return statements;
    }

    private static PointPlan points(JsonFields fields) {
        PointPlan plan =
                new PointPlan(
                        fields.integer("accuracy", 0, Exercise.MOST_POINTS),
                        fields.integer("stability", 0, Exercise.MOST_POINTS),
                        fields.integer("speed", 0, Exercise.MOST_POINTS));
        if (plan.total() != 100)
            throw fields.wrong(
                    "", Phrase.of("field.sum", plan.accuracy(), plan.stability(), plan.speed()));
        return plan;
    }

    private List<Case> cases(String file, TopicGrading topic, List<String> groups, Shapes shapes) {
        List<Case> cases = new ArrayList<>();
        for (JsonFields fields :
                JsonFields.parseArray(folder.place(file), folder.text(file), CASE_FIELDS))
            cases.add(checked(fields, oneCase(fields, groups, shapes), topic));
        return cases;
    }

    private static Case oneCase(JsonFields fields, List<String> groups, Shapes shapes) {
        String name = name(fields);
        boolean generated = fields.has("generate");
        if (generated == fields.has("input"))
            throw fields.wrong("", Phrase.of("field.either", "input", "generate"));
        Disclosure visibility =
                Disclosure.valueOf(
                        constant(
                                fields.word(
                                        "visibility",
                                        List.of(
                                                "open",
                                                "verdict-only",
                                                "after-deadline",
                                                "never"))));
        if (generated && visibility == Disclosure.OPEN)
            throw fields.wrong("visibility", Phrase.of("field.generated"));
        return new Case(
                name,
                fields.has("title") ? titles(fields.object("title", "en", "ru")) : Map.of(),
                fields.has("group") ? fields.word("group", groups) : name,
                Kind.valueOf(constant(fields.word("kind", List.of("accuracy", "stability")))),
                visibility,
                fields.integer("points", 0, Exercise.MOST_POINTS),
                generated ? shapes.given(fields.object("generate")) : fields.json("input"),
                generated);
    }

    /** Lower-case words with hyphens. */
    static String name(JsonFields fields) {
        String name = fields.text("name");
        if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*"))
            throw fields.wrong("name", Phrase.of("field.words", name));
        return name;
    }

    /** Reads the input as the runner will, so that a mistake shows before anybody submits. */
    private static Case checked(JsonFields fields, Case one, TopicGrading topic) {
        try {
            topic.calls(one, new Tolerance(false), 0);
            return one;
        } catch (CatalogueException e) {
            throw fields.wrong("", Phrase.of("field.unusable", e.said()));
        }
    }

    private static String constant(String word) {
        return word.toUpperCase(Locale.ROOT).replace('-', '_');
    }

    private void checkNames(List<Case> cases) {
        Set<String> names = new HashSet<>();
        for (Case one : cases)
            if (!names.add(one.name())) throw wrong("cases", Phrase.of("field.twice", one.name()));
    }

    private void checkSum(List<Case> cases, Kind kind, int planned) {
        int sum = cases.stream().filter(one -> one.kind() == kind).mapToInt(Case::points).sum();
        if (sum != planned)
            throw wrong("cases", Phrase.of("field.cases." + kindName(kind), sum, planned));
    }

    /** A right answer must not be stopped. */
    private void checkItems(Exercise exercise, TopicGrading topic) {
        if (exercise.caps().items().isEmpty()) return;
        int most = exercise.caps().items().getAsInt();
        for (Case one : exercise.cases())
            for (TopicGrading.Call call : topic.calls(one, exercise.tolerance(), 0))
                if (call.items() > most)
                    throw wrong(
                            "caps.items", Phrase.of("field.caps", one.name(), call.items(), most));
    }

    private CatalogueException wrong(String field, Phrase reason) {
        return new CatalogueException(
                Phrase.of(
                        "folder.at",
                        Phrase.of("field", folder.place("exercise.json"), field),
                        reason));
    }

    private static String kindName(Kind kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }
}
