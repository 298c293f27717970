package rasterlab.exercises.catalogue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import rasterlab.exercises.Exercise.Group;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.json.JsonFields;
import rasterlab.exercises.score.Phrase;

/** Reads what the cases of an exercise ask for. */
final class GroupReader {
    private GroupReader() {}

    static List<Group> read(JsonFields exercise, TopicGrading topic) {
        List<Group> groups = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (JsonFields fields : exercise.objects("groups", "name", "title", "mistakes")) {
            String name = ExerciseReader.name(fields);
            if (!names.add(name)) throw fields.wrong("name", Phrase.of("field.group.twice", name));
            groups.add(
                    new Group(
                            name,
                            ExerciseReader.titles(fields.object("title", "en", "ru")),
                            mistakes(fields, topic)));
        }
        return groups;
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

    static List<String> names(List<Group> groups) {
        return groups.stream().map(Group::name).toList();
    }
}
