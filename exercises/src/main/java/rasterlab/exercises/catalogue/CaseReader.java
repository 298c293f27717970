package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.CatalogueException;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Case;
import rasterlab.exercises.Exercise.Kind;
import rasterlab.exercises.Exercise.Tolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.property.Properties;
import rasterlab.exercises.property.Property;
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Phrase;

/** Reads the cases of an exercise, whose files {@code exercise.json} names. */
final class CaseReader {
    private static final String[] FIELDS = {
        "name", "title", "group", "kind", "visibility", "points", "input", "generate", "property"
    };

    private static final List<String> ASKED = List.of("input", "generate", "property");

    private final ExerciseFolder folder;
    private final Faults faults;
    private final Optional<TopicGrading> topic;
    private final List<String> groups;
    private final Shapes shapes;

    /**
     * @param topic empty where it is not known: then no input is looked at
     * @param groups the names that a case may give as its group
     * @param shapes the templates that a case may name
     */
    CaseReader(
            ExerciseFolder folder,
            Faults faults,
            Optional<TopicGrading> topic,
            List<String> groups,
            Shapes shapes) {
        this.folder = folder;
        this.faults = faults;
        this.topic = topic;
        this.groups = groups;
        this.shapes = shapes;
    }

    List<Case> read(JsonFields exercise) {
        List<Case> cases = new ArrayList<>();
        for (String file : faults.tried(() -> exercise.texts("cases")).orElse(List.of()))
            for (JsonFields fields :
                    faults.tried(() -> JsonFields.parseArray(folder.place(file), folder.text(file)))
                            .orElse(List.of())) {
                faults.checkKnown(fields, FIELDS);
                faults.tried(() -> checked(fields, oneCase(fields))).ifPresent(cases::add);
            }
        checkNames(cases);
        return cases;
    }

    private Case oneCase(JsonFields fields) {
        String name = ExerciseReader.name(fields);
        String asked = asked(fields);
        Optional<JsonFields> property =
                asked.equals("property")
                        ? Optional.of(fields.object("property"))
                        : Optional.empty();
        boolean generated = property.map(one -> !one.has("seed")).orElse(asked.equals("generate"));
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
            throw fields.wrong(
                    "visibility",
                    Phrase.of(property.isPresent() ? "field.unseeded" : "field.generated"));
        return new Case(
                name,
                fields.has("title")
                        ? ExerciseReader.titles(fields.object("title", "en", "ru"))
                        : Map.of(),
                fields.has("group") ? fields.word("group", groups) : name,
                Kind.valueOf(constant(fields.word("kind", List.of("accuracy", "stability")))),
                visibility,
                fields.integer("points", 0, Exercise.MOST_POINTS),
                asked.equals("input")
                        ? fields.json("input")
                        : shapes.given(fields.object(asked), "holds"),
                generated,
                property.map(this::property));
    }

    /** The one field that says what a case asks for. */
    private static String asked(JsonFields fields) {
        List<String> given = ASKED.stream().filter(fields::has).toList();
        if (given.size() == 1) return given.get(0);
        throw fields.wrong("", Phrase.of("field.one-of", String.join(", ", ASKED)));
    }

    /** The name of a property of the exercise's topic; any where the topic is not known. */
    private String property(JsonFields fields) {
        String name = fields.text("holds");
        if (topic.isEmpty()) return name;
        List<String> own = names(Properties.of(topic.get().name()));
        if (own.contains(name)) return name;
        List<String> others =
                Properties.all().stream()
                        .filter(one -> one.name().equals(name))
                        .map(Property::topic)
                        .toList();
        if (others.isEmpty() || own.isEmpty())
            throw fields.wrong(
                    "holds",
                    own.isEmpty()
                            ? Phrase.of("property.none", topic.get().name())
                            : Phrase.of("field.word", String.join(", ", own), name));
        throw fields.wrong(
                "holds",
                Phrase.of(
                        "property.other",
                        name,
                        String.join(", ", others),
                        topic.get().name(),
                        String.join(", ", own)));
    }

    private static List<String> names(List<Property<?, ?>> properties) {
        return properties.stream().map(Property::name).toList();
    }

    /** Reads the input as the runner will, so that a mistake shows before anybody submits. */
    private Case checked(JsonFields fields, Case one) {
        if (folder.tested()) return one;
        try {
            topic.ifPresent(known -> known.calls(one, new Tolerance(false), 0));
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
            faults.checked(
                    () -> {
                        if (!names.add(one.name()))
                            throw ExerciseReader.wrong(
                                    folder, "cases", Phrase.of("field.twice", one.name()));
                    });
    }
}
