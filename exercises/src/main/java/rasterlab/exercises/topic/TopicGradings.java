package rasterlab.exercises.topic;

import java.util.List;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.graded.ClipGrading;
import rasterlab.exercises.graded.FaceGrading;
import rasterlab.exercises.graded.TriangleGrading;
import rasterlab.exercises.line.LineGrading;

/** The topics that can be graded, by name. A further topic is one more line here. */
public final class TopicGradings {
    private TopicGradings() {}

    public static List<TopicGrading> all() {
        return List.of(
                new LineGrading(), new TriangleGrading(), new ClipGrading(), new FaceGrading());
    }

    public static List<String> names() {
        return all().stream().map(TopicGrading::name).toList();
    }

    /**
     * The topic of that name.
     *
     * @throws IllegalArgumentException when there is none; names those there are
     */
    public static TopicGrading named(String name) {
        return all().stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "no topic '"
                                                + name
                                                + "' can be graded; there are "
                                                + String.join(", ", names())));
    }
}
