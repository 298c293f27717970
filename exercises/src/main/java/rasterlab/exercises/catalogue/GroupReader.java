package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rasterlab.exercises.Exercise.CaseGroup;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.json.Faults;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/** Reads what the cases of an exercise ask for. */
final class GroupReader {
    private final Faults faults;

    GroupReader(Faults faults) {
        this.faults = faults;
    }

    /**
     * @param topic empty where it is not known: then no mistake is looked at
     */
    List<CaseGroup> read(JsonFields exercise, Optional<TopicGrading> topic) {
        List<CaseGroup> groups = new ArrayList<>();
        Set<String> names = new HashSet<>();
        List<JsonFields> objects =
                faults.tried(() -> exercise.objects("groups", "name", "title", "mistakes"))
                        .orElse(List.of());
        for (JsonFields fields : objects) group(fields, names, topic).ifPresent(groups::add);
        return groups;
    }

    /** A group; empty where something is wrong, all of which is kept. */
    private Optional<CaseGroup> group(
            JsonFields fields, Set<String> names, Optional<TopicGrading> topic) {
        Optional<String> name = faults.tried(() -> name(fields, names));
        var titles = ExerciseReader.titles(fields, faults);
        Optional<Set<String>> mistakes =
                topic.isEmpty()
                        ? Optional.of(Set.of())
                        : faults.tried(() -> mistakes(fields, topic.get()));
        return name.isPresent() && titles.isPresent() && mistakes.isPresent()
                ? Optional.of(new CaseGroup(name.get(), titles.get(), mistakes.get()))
                : Optional.empty();
    }

    private static String name(JsonFields fields, Set<String> names) {
        String name = ExerciseReader.name(fields);
        if (!names.add(name)) throw fields.wrong("name", Phrase.of("field.group.twice", name));
        return name;
    }

    private static Set<String> mistakes(JsonFields fields, TopicGrading topic) {
        if (!fields.has("mistakes")) return Set.of();
        Set<String> mistakes = new HashSet<>(fields.texts("mistakes"));
        String known = String.join(", ", new TreeSet<>(topic.mistakes()));
        for (String one : mistakes)
            if (!topic.mistakes().contains(one))
                throw fields.wrong("mistakes", Phrase.of("field.word", known, one));
        return mistakes;
    }

    static List<String> names(List<CaseGroup> groups) {
        return groups.stream().map(CaseGroup::name).toList();
    }
}
