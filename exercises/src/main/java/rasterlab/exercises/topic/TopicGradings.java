package rasterlab.exercises.topic;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.contract.Pixels;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.graded.AnyGrading;
import rasterlab.exercises.graded.ClipGrading;
import rasterlab.exercises.graded.FaceGrading;
import rasterlab.exercises.graded.ShadeGrading;
import rasterlab.exercises.graded.TopicPart;
import rasterlab.exercises.graded.TriangleGrading;
import rasterlab.exercises.line.LineGrading;

/**
 * The gradings of topics: of all whose contract students may see. Most are derived from the topic;
 * those that add to it say themselves which topic they grade.
 */
public final class TopicGradings {
    private static final String FOR_STUDENTS = Pixels.class.getPackageName();

    private TopicGradings() {}

    /** The gradings that cannot be derived from their topics alone. */
    static List<TopicGrading> own() {
        return List.of(
                new LineGrading(),
                new TriangleGrading(),
                new ClipGrading(),
                new ShadeGrading(),
                new FaceGrading());
    }

    /** The names of the topics that can be graded, in the course's order. */
    public static List<String> names() {
        return Gradable.NAMES;
    }

    /** The contracts that a student may be asked to implement. */
    public static List<Class<?>> contracts() {
        return Stream.<Class<?>>concat(
                        gradable().map(Topic::contract),
                        TopicPart.all().stream().map(TopicPart::contract))
                .toList();
    }

    private static Stream<Topic<?, ?, ?>> gradable() {
        return Topics.all().stream().filter(TopicGradings::isGradable);
    }

    private static boolean isGradable(Topic<?, ?, ?> topic) {
        return topic.contract().getPackageName().equals(FOR_STUDENTS);
    }

    /** Names of the smaller contracts that an exercise on that topic may ask for. */
    public static List<String> parts(String topic) {
        return TopicPart.of(Topics.named(topic)).map(TopicPart::name).toList();
    }

    /** The grading of an exercise: of its topic, or of the part that it asks for. */
    public static TopicGrading of(Exercise exercise) {
        return named(exercise.topic(), exercise.contract());
    }

    /**
     * The grading of a topic, or of a part of it.
     *
     * @param contract simple name of a smaller one; empty for the topic's own
     * @throws IllegalArgumentException when there is no such topic or part; names those there are
     */
    public static TopicGrading named(String name, Optional<String> contract) {
        if (contract.isEmpty()) return named(name);
        Topic<?, ?, ?> topic = Topics.named(name);
        TopicPart<?, ?> part =
                TopicPart.of(topic)
                        .filter(one -> one.name().equals(contract.get()))
                        .findFirst()
                        .orElseThrow(
                                () ->
                                        new IllegalArgumentException(
                                                "no contract '%s' of '%s'; there are %s"
                                                        .formatted(
                                                                contract.get(),
                                                                name,
                                                                parts(name))));
        return AnyGrading.ofPart(topic, part);
    }

    /**
     * The grading of the topic of that name.
     *
     * @throws IllegalArgumentException when there is none; names those there are
     */
    public static TopicGrading named(String name) {
        return own().stream()
                .filter(one -> one.name().equals(name))
                .findFirst()
                .orElseGet(() -> derived(Topics.named(name)));
    }

    private static TopicGrading derived(Topic<?, ?, ?> topic) {
        if (isGradable(topic)) return AnyGrading.of(topic);
        throw new IllegalArgumentException(
                "no topic '%s' can be graded; there are %s"
                        .formatted(topic.name(), String.join(", ", names())));
    }

    /**
     * The topics that can be graded, worked out once, when somebody asks: each topic has to be made
     * for it.
     */
    private static final class Gradable {
        static final List<String> NAMES = gradable().map(Topic::name).toList();
    }
}
