package rasterlab.exercises.catalogue;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import rasterlab.engine.Topics;
import rasterlab.engine.format.Field;
import rasterlab.engine.format.Shape;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.CaseGroup;
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.Evidence;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.Exercise.PointPlan;
import rasterlab.exercises.Exercise.StatedLimits;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.Hint;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;
import rasterlab.exercises.topic.TopicGradings;

/**
 * Turns an exercise folder into an {@link Exercise}, or says which field of which file is wrong.
 */
final class ExerciseReader {
    private static final List<String> LANGUAGES = List.of("en", "ru");
    private static final String[] FIELDS = {
        "topic",
        "contract",
        "title",
        "tolerance",
        "truth",
        "points",
        "caps",
        "timed",
        "shapes",
        "groups",
        "cases",
        "model",
        "notAsked",
        "kind",
        "minutes",
        HintReader.COSTS,
        "break",
        "predict"
    };

    private static final Field<Double> WORST =
            Field.required("worst", Shape.number(0, Double.MAX_VALUE));

    private static final Field<Double> SECONDS =
            Field.required(
                    "seconds", Shape.number(StatedLimits.LEAST_SECONDS, StatedLimits.MOST_SECONDS));

    private static final List<String> FORMS =
            Stream.of(TaskKind.values()).map(TaskKind::code).toList();

    private final ExerciseFolder folder;
    private final Faults faults = new Faults();

    /** The fields of {@code exercise.json}; empty until it is read, or where it cannot be. */
    private Optional<JsonFields> fields = Optional.empty();

    ExerciseReader(ExerciseFolder folder) {
        this.folder = folder;
    }

    /**
     * @throws CatalogueException naming the first fault
     */
    Exercise read() {
        Optional<Exercise> read = tried();
        faults.requireNone();
        return read.orElseThrow();
    }

    /** The exercise and all faults, of which there are none where it can be taken. */
    Catalogue.FolderReading reading() {
        Optional<Exercise> read = tried();
        if (faults.all().isEmpty()) CapsCheck.check(folder, read.orElseThrow(), faults);
        FolderParts parts = FolderParts.of(folder, fields, faults);
        return new Catalogue.FolderReading(
                faults.all().isEmpty() ? read : Optional.empty(), faults.all(), parts);
    }

    /** The exercise, where nothing is wrong with it. */
    private Optional<Exercise> tried() {
        String id = folder.id();
        faults.checked(
                () -> {
                    if (!id.matches("[a-z0-9]+(-[a-z0-9]+)*"))
                        throw new CatalogueException(Phrase.of("folder.words", id));
                });
        fields = faults.tried(this::fields);
        return fields.flatMap(all -> tried(id, all));
    }

    /** The minutes that it usually takes, where the folder says so. */
    static OptionalInt minutes(JsonFields fields) {
        return fields.has("minutes")
                ? OptionalInt.of(fields.integer("minutes", 1, Exercise.MOST_MINUTES))
                : OptionalInt.empty();
    }

    private JsonFields fields() {
        String file = "exercise.json";
        JsonFields fields =
                JsonFields.parse(folder.place(file), folder.text(file)).keeping(faults::keep);
        faults.checkKnown(fields, FIELDS);
        return fields;
    }

    private Optional<Exercise> tried(String id, JsonFields fields) {
        Optional<String> form = form(fields, faults);
        if (form.isEmpty()) return Optional.empty();
        if (form.get().equals(TaskKind.BREAK.code()))
            return new BreakingReader(folder, fields, faults).read();
        if (form.get().equals(TaskKind.PREDICT.code()))
            return new PredictingReader(folder, fields, faults).read();
        return written(id, fields);
    }

    /** The code of the form; empty where it is unknown, which is kept. */
    static Optional<String> form(JsonFields fields, Faults faults) {
        return faults.tried(() -> fields.word("kind", FORMS, TaskKind.WRITE.code()));
    }

    private Optional<Exercise> written(String id, JsonFields fields) {
        Optional<TopicGrading> topic = faults.tried(() -> grading(fields));
        Optional<PointPlan> points = points(fields);
        List<CaseGroup> groups = new GroupReader(faults).read(fields, topic);
        int before = faults.all().size();
        List<Case> cases = cases(fields, topic, groups);
        // without a case that cannot be read the sums say nothing
        if (before == faults.all().size()) points.ifPresent(plan -> checkSums(cases, plan));
        Map<String, String> statements = statements(folder, faults);
        var titles = titles(fields, faults);
        var pictures =
                new StatementPictures(folder, topic.map(TopicGrading::name))
                        .read(statements, faults);
        var starter = faults.tried(() -> folder.text("Starter.java"));
        var tolerance = topic.flatMap(one -> faults.tried(() -> tolerance(fields, one)));
        var caps = stated(fields);
        var evidence = topic.flatMap(one -> faults.tried(() -> evidence(fields, one)));
        var minutes = faults.tried(() -> minutes(fields));
        var timed =
                faults.tried(
                        () ->
                                fields.has("timed")
                                        ? Optional.of(timed(fields))
                                        : Optional.<String>empty());
        String revision = Revision.of(folder.read());
        List<Hint> hints = new HintReader(folder, fields, faults).read();
        if (!faults.all().isEmpty()) return Optional.empty();
        Exercise read =
                new Exercise(
                        id,
                        topic.orElseThrow().name(),
                        contract(fields, topic.orElseThrow().name()),
                        titles.orElseThrow(),
                        statements,
                        pictures,
                        starter.orElseThrow(),
                        revision,
                        tolerance.orElseThrow(),
                        points.orElseThrow(),
                        caps.orElseThrow(),
                        timed.orElseThrow(),
                        groups,
                        cases,
                        Optional.empty(),
                        Optional.empty(),
                        evidence.orElseThrow(),
                        minutes.orElseThrow(),
                        hints);
        if (!folder.tested()) faults.checked(() -> checkTimings(fields, topic.orElseThrow(), read));
        return Optional.of(read);
    }

    private static String timed(JsonFields fields) {
        return fields.object("timed", "count", "let", "given", "parts").tree().toString();
    }

    static TopicGrading grading(JsonFields fields) {
        String topic = fields.word("topic", TopicGradings.names());
        return TopicGradings.named(topic, contract(fields, topic));
    }

    /** A smaller contract of the topic, where one is asked for. */
    private static Optional<String> contract(JsonFields fields, String topic) {
        return fields.has("contract")
                ? Optional.of(fields.word("contract", TopicGradings.parts(topic)))
                : Optional.empty();
    }

    private List<Case> cases(
            JsonFields fields, Optional<TopicGrading> topic, List<CaseGroup> groups) {
        return faults.tried(() -> InputTemplates.read(fields))
                .map(
                        shapes ->
                                new CaseReader(
                                                folder,
                                                faults,
                                                topic,
                                                GroupReader.names(groups),
                                                shapes)
                                        .read(fields))
                .orElse(List.of());
    }

    /** Asks for inputs to measure speed on, so that a mistake shows before anybody submits. */
    private static void checkTimings(JsonFields fields, TopicGrading topic, Exercise read) {
        try {
            topic.timings(read, new Random(0), List.of());
        } catch (CatalogueException e) {
            throw fields.wrong("", Phrase.of("field.unusable", e.phrase()));
        }
    }

    private static JsonFields tolerances(JsonFields fields) {
        return fields.object("tolerance", "eitherPixelOnTies", "worst", "unit");
    }

    /** The limits; empty where one is wrong, all of which are kept. */
    private Optional<StatedLimits> stated(JsonFields fields) {
        if (!fields.has("caps")) return Optional.of(StatedLimits.NONE);
        return faults.tried(() -> fields.object("caps", "items", "bytes", "seconds"))
                .flatMap(this::caps);
    }

    /** The names of the topic's faulty methods, and of its mutants or those of one method. */
    private static <C> List<String> mistakes(Topic<C, ?, ?> topic, Optional<String> method) {
        List<Mutant<C>> mutants = method.map(topic::mutants).orElseGet(topic::mutants);
        return Stream.concat(
                        topic.methods().stream().filter(Method::faulty).map(Method::name),
                        mutants.stream().map(Mutant::name))
                .toList();
    }

    /** A topic without a method of its own to hold speed against asks for a model solution. */
    private Evidence evidence(JsonFields fields, TopicGrading topic) {
        Set<String> notAsked =
                fields.has("notAsked") ? new LinkedHashSet<>(fields.texts("notAsked")) : Set.of();
        List<String> known = mistakes(Topics.named(topic.name()), truth(fields, topic));
        for (String one : notAsked)
            if (!known.contains(one))
                faults.keep(
                        fields.wrong(
                                "notAsked",
                                Phrase.of("field.word", String.join(", ", known), one)));
        if (!fields.has("model") && topic.reference().isPresent())
            return new Evidence(Optional.empty(), notAsked);
        return new Evidence(Optional.of(folder.text(fields.text("model"))), notAsked);
    }

    /** An error is stated with its unit, so that nobody takes pixels for shares. */
    private static ExerciseTolerance tolerance(JsonFields exercise, TopicGrading topic) {
        Optional<String> truth = truth(exercise, topic);
        JsonFields fields = tolerances(exercise);
        boolean either = fields.flag("eitherPixelOnTies", false);
        if (!fields.has("worst") && !fields.has("unit"))
            return new ExerciseTolerance(either, OptionalDouble.empty(), truth);
        if (topic.unit().isEmpty()) throw fields.wrong("worst", Phrase.of("field.no-tolerance"));
        fields.word("unit", List.of(topic.unit().get()));
        return new ExerciseTolerance(either, OptionalDouble.of(fields.get(WORST)), truth);
    }

    private static Optional<String> truth(JsonFields fields, TopicGrading topic) {
        if (!fields.has("truth")) return Optional.empty();
        if (topic.truths().isEmpty()) throw fields.wrong("truth", Phrase.of("field.no-truth"));
        return Optional.of(fields.word("truth", topic.truths()));
    }

    private Optional<StatedLimits> caps(JsonFields fields) {
        var items = faults.tried(() -> whole(fields, "items", StatedLimits.MOST_ITEMS));
        var bytes = faults.tried(() -> whole(fields, "bytes", StatedLimits.MOST_BYTES));
        var seconds = faults.tried(() -> seconds(fields));
        return items.isPresent() && bytes.isPresent() && seconds.isPresent()
                ? Optional.of(new StatedLimits(items.get(), bytes.get(), seconds.get()))
                : Optional.empty();
    }

    private static Optional<Duration> seconds(JsonFields fields) {
        return fields.has("seconds")
                ? Optional.of(Duration.ofNanos(Math.round(fields.get(SECONDS) * 1e9)))
                : Optional.empty();
    }

    private static OptionalInt whole(JsonFields fields, String field, int most) {
        return fields.has(field)
                ? OptionalInt.of(fields.integer(field, 1, most))
                : OptionalInt.empty();
    }

    /** The title in each language; empty where one is missing, which is kept. */
    static Optional<Map<String, String>> titles(JsonFields fields, Faults faults) {
        return faults.tried(() -> fields.object("title", "en", "ru"))
                .flatMap(all -> texts(all, faults));
    }

    /** A text in each language; empty where one is missing, which is kept. */
    static Optional<Map<String, String>> texts(JsonFields fields, Faults faults) {
        Map<String, String> texts = new LinkedHashMap<>();
        for (String language : LANGUAGES)
            faults.tried(() -> fields.text(language)).ifPresent(text -> texts.put(language, text));
        return texts.size() == LANGUAGES.size() ? Optional.of(texts) : Optional.empty();
    }

    /** The statements; one that is missing or has no words is kept as a fault. */
    static Map<String, String> statements(ExerciseFolder folder, Faults faults) {
        Map<String, String> statements = new LinkedHashMap<>();
        for (String language : LANGUAGES)
            faults.tried(() -> statement(folder, StatementPictures.file(language)))
                    .ifPresent(text -> statements.put(language, text));
        return statements;
    }

    private static String statement(ExerciseFolder folder, String file) {
        String text = folder.text(file);
        if (text.lines().allMatch(line -> line.isBlank() || line.startsWith("# ")))
            throw new CatalogueException(Phrase.of("statement.empty", folder.place(file)));
        return text;
    }

    private Optional<PointPlan> points(JsonFields fields) {
        Optional<JsonFields> all =
                faults.tried(() -> fields.object("points", "accuracy", "stability", "speed"));
        if (all.isEmpty()) return Optional.empty();
        Optional<Integer> accuracy = points(all.get(), "accuracy");
        Optional<Integer> stability = points(all.get(), "stability");
        Optional<Integer> speed = points(all.get(), "speed");
        if (accuracy.isEmpty() || stability.isEmpty() || speed.isEmpty()) return Optional.empty();
        var plan = new PointPlan(accuracy.get(), stability.get(), speed.get());
        return faults.tried(() -> wholePlan(all.get(), plan));
    }

    private Optional<Integer> points(JsonFields all, String kind) {
        return faults.tried(() -> all.integer(kind, 0, Exercise.MOST_POINTS));
    }

    private static PointPlan wholePlan(JsonFields fields, PointPlan plan) {
        if (plan.total() != 100)
            throw fields.wrong(
                    "", Phrase.of("field.sum", plan.accuracy(), plan.stability(), plan.speed()));
        return plan;
    }

    /** Lower-case words with hyphens. */
    static String name(JsonFields fields) {
        String name = fields.text("name");
        if (!name.matches("[a-z0-9]+(-[a-z0-9]+)*"))
            throw fields.wrong("name", Phrase.of("field.words", name));
        return name;
    }

    private void checkSums(List<Case> cases, PointPlan points) {
        faults.checked(() -> checkSum(cases, Criterion.ACCURACY, points.accuracy()));
        faults.checked(() -> checkSum(cases, Criterion.STABILITY, points.stability()));
    }

    private void checkSum(List<Case> cases, Criterion kind, int planned) {
        int sum = cases.stream().filter(one -> one.kind() == kind).mapToInt(Case::points).sum();
        if (sum != planned)
            throw wrong(folder, "cases", Phrase.of("field.cases." + kindName(kind), sum, planned));
    }

    static CatalogueException wrong(ExerciseFolder folder, String field, Phrase reason) {
        return new CatalogueException(
                Phrase.of(
                        "folder.at",
                        Phrase.of("field", folder.place("exercise.json"), field),
                        reason));
    }

    private static String kindName(Criterion kind) {
        return kind.name().toLowerCase(Locale.ROOT);
    }
}
