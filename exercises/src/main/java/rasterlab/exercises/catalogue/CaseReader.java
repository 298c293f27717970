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
import rasterlab.exercises.Exercise.Criterion;
import rasterlab.exercises.Exercise.ExerciseTolerance;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.json.Faults;
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

    /** The fields of each. */
    private static final Map<String, String[]> WITHIN =
            Map.of(
                    "input",
                            new String[] {
                                "given", "hazard", "scene", "mayRefuse", "strict", "first"
                            },
                    "generate", new String[] {"shape", "count", "let", "given", "strict"},
                    "property", new String[] {"holds", "shape", "count", "let", "given", "seed"});

    private static final List<String> KINDS = List.of("accuracy", "stability");

    private static final List<String> VISIBILITIES =
            List.of("open", "verdict-only", "after-deadline", "never");

    private final ExerciseFolder folder;
    private final Faults faults;
    private final Optional<TopicGrading> topic;
    private final List<String> groups;
    private final InputTemplates shapes;
    private final CaseScenes scenes;

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
            InputTemplates shapes) {
        this.folder = folder;
        this.faults = faults;
        this.topic = topic;
        this.groups = groups;
        this.shapes = shapes;
        scenes = new CaseScenes(folder, topic);
    }

    List<Case> read(JsonFields exercise) {
        List<Case> cases = new ArrayList<>();
        for (String file : faults.tried(() -> exercise.texts("cases")).orElse(List.of()))
            for (JsonFields fields :
                    faults.tried(() -> JsonFields.parseArray(folder.place(file), folder.text(file)))
                            .orElse(List.of())) {
                faults.checkKnown(fields, FIELDS);
                oneCase(fields.keeping(faults::keep)).ifPresent(cases::add);
            }
        checkNames(cases);
        return cases;
    }

    /** The contents of a case: its data, whether a seed draws it, and its property. */
    private record CaseSource(String data, boolean generated, Optional<String> property) {}

    /** A case; empty where something is wrong, all of which is kept. */
    private Optional<Case> oneCase(JsonFields fields) {
        int before = faults.all().size();
        Optional<String> name = faults.tried(() -> ExerciseReader.name(fields));
        var titles =
                fields.has("title")
                        ? ExerciseReader.titles(fields, faults)
                        : Optional.of(Map.<String, String>of());
        Optional<String> group =
                fields.has("group") ? faults.tried(() -> fields.word("group", groups)) : name;
        Optional<Criterion> kind =
                faults.tried(() -> Criterion.valueOf(word(fields, "kind", KINDS)));
        Optional<Disclosure> visibility =
                faults.tried(() -> Disclosure.valueOf(word(fields, "visibility", VISIBILITIES)));
        Optional<Integer> points =
                faults.tried(() -> fields.integer("points", 0, Exercise.MOST_POINTS));
        Optional<CaseSource> asked = faults.tried(() -> asked(fields));
        if (asked.isPresent())
            visibility =
                    visibility.flatMap(one -> faults.tried(() -> seen(fields, asked.get(), one)));
        if (name.isEmpty() || asked.isEmpty()) return Optional.empty();
        // what stands in for a fault here is in no exercise, but its inputs are looked at
        Case one =
                new Case(
                        name.get(),
                        titles.orElse(Map.of()),
                        group.orElse(name.get()),
                        kind.orElse(Criterion.ACCURACY),
                        visibility.orElse(Disclosure.NEVER),
                        points.orElse(0),
                        asked.get().data(),
                        asked.get().generated(),
                        asked.get().property());
        faults.checked(() -> check(fields, one));
        return faults.all().size() > before ? Optional.empty() : Optional.of(one);
    }

    private static String word(JsonFields fields, String field, List<String> allowed) {
        return constant(fields.word(field, allowed));
    }

    /** The visibility of a case; an open one is the same for everybody. */
    private static Disclosure seen(JsonFields fields, CaseSource asked, Disclosure visibility) {
        if (asked.generated() && visibility == Disclosure.OPEN)
            throw fields.wrong(
                    "visibility",
                    Phrase.of(asked.property().isPresent() ? "field.unseeded" : "field.generated"));
        return visibility;
    }

    private CaseSource asked(JsonFields fields) {
        String field = askedField(fields);
        JsonFields all = fields.object(field, WITHIN.get(field));
        if (field.equals("input"))
            return new CaseSource(scenes.given(all), false, Optional.empty());
        String data = shapes.given(all, "holds");
        return field.equals("property")
                ? new CaseSource(data, !all.has("seed"), Optional.of(property(all)))
                : new CaseSource(data, true, Optional.empty());
    }

    /** The one field that says what a case asks for. */
    private static String askedField(JsonFields fields) {
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
    private void check(JsonFields fields, Case one) {
        if (folder.tested()) return;
        try {
            topic.ifPresent(known -> known.calls(one, new ExerciseTolerance(false), 0));
        } catch (CatalogueException e) {
            throw fields.wrong("", Phrase.of("field.unusable", e.phrase()));
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
