package rasterlab.exercises.folder;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;

/**
 * Makes the files of an exercise to begin with from those of the course's own one of that form on
 * the topic: how inputs are drawn, what is asked for and what pays is then changed to taste.
 */
public final class CopiedFolder {
    private CopiedFolder() {}

    /** The topics of the course's exercises of that form, in its order. */
    public static List<String> topics(TaskKind form) {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == form)
                .map(Exercise::topic)
                .distinct()
                .toList();
    }

    /**
     * Name to content of each file; empty where there is no such exercise on the topic.
     *
     * @param id of the new exercise, which its texts name
     */
    public static Optional<Map<String, byte[]>> files(String topic, TaskKind form, String id) {
        Catalogue catalogue = Catalogue.builtIn();
        return catalogue.all().stream()
                .filter(one -> one.form() == form && one.topic().equals(topic))
                .findFirst()
                .map(one -> renamed(catalogue.files(one.id()), one.id(), id));
    }

    private static Map<String, byte[]> renamed(Map<String, byte[]> files, String old, String id) {
        Map<String, byte[]> renamed = new TreeMap<>(files);
        renamed.replaceAll(
                (name, content) ->
                        name.endsWith(".md")
                                ? new String(content, StandardCharsets.UTF_8)
                                        .replace(old, id)
                                        .getBytes(StandardCharsets.UTF_8)
                                : content);
        return renamed;
    }
}
