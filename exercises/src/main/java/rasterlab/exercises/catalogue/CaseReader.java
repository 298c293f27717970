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
import rasterlab.exercises.score.Disclosure;
import rasterlab.exercises.score.Phrase;

/** Reads the cases of an exercise, whose files {@code exercise.json} names. */
final class CaseReader {
    private static final String[] FIELDS = {
        "name", "title", "group", "kind", "visibility", "points", "input", "generate"
    };

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
                    faults.tried(
                                    () ->
                                            JsonFields.parseArray(
                                                    folder.place(file), folder.text(file), FIELDS))
                            .orElse(List.of()))
                faults.tried(() -> checked(fields, oneCase(fields))).ifPresent(cases::add);
        checkNames(cases);
        return cases;
    }

    private Case oneCase(JsonFields fields) {
        String name = ExerciseReader.name(fields);
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
                fields.has("title")
                        ? ExerciseReader.titles(fields.object("title", "en", "ru"))
                        : Map.of(),
                fields.has("group") ? fields.word("group", groups) : name,
                Kind.valueOf(constant(fields.word("kind", List.of("accuracy", "stability")))),
                visibility,
                fields.integer("points", 0, Exercise.MOST_POINTS),
                generated ? shapes.given(fields.object("generate")) : fields.json("input"),
                generated);
    }

    /** Reads the input as the runner will, so that a mistake shows before anybody submits. */
    private Case checked(JsonFields fields, Case one) {
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
