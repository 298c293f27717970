package rasterlab.app.practice;

import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.Sheet;

/** The exercises whose questions are practised, one a topic; read when they are first needed. */
public final class PracticeExercises {
    private final Catalogue catalogue = Catalogue.builtIn();
    private final Map<String, Optional<Exercise>> byTopic = new ConcurrentHashMap<>();

    /** Answers which questions the seed draws for a topic; takes long, on any thread. */
    PracticeSheet sheet(String topic, long seed) {
        Exercise exercise =
                of(topic)
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "no exercise asks for steps of topic '"
                                                        + topic
                                                        + "'"));
        return new PracticeSheet(
                exercise, Sheet.of(topic, exercise.predicting().orElseThrow(), seed));
    }

    /** The first exercise of the topic that asks for predictions. */
    Optional<Exercise> of(String topic) {
        return byTopic.computeIfAbsent(topic, this::found);
    }

    /** Tries the usual name first, since reading all exercises takes seconds. */
    private Optional<Exercise> found(String topic) {
        String usual = "predict-" + topic;
        return catalogue.ids().stream()
                .sorted(Comparator.comparing(id -> !id.equals(usual)))
                .map(catalogue::named)
                .filter(one -> one.form() == TaskKind.PREDICT && one.topic().equals(topic))
                .findFirst();
    }
}
