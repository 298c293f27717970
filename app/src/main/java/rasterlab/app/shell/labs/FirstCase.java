package rasterlab.app.shell.labs;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import rasterlab.app.canvas.lab.GivenInput;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.scene.MethodCase;

/**
 * The case of an exercise that a window opens with, in the lab of its topic.
 *
 * @param program the user's own, shown beside the right method; empty for none
 */
public record FirstCase(MethodCase scene, Optional<WrittenSource> program) {
    private static final Pattern COMMENT = Pattern.compile("//.*|/\\*[\\s\\S]*?\\*/");

    /**
     * A source that was written for an exercise.
     *
     * @param file that it was read from
     */
    public record WrittenSource(Exercise exercise, String source, String file) {}

    /**
     * @throws IllegalArgumentException if there is no such topic or method, or the input cannot be
     *     read
     */
    public FirstCase {
        Topic<?, ?, ?> topic = Topics.named(scene.topic());
        scene.method().ifPresent(topic::method);
        GivenInput.read(topic.format(), scene.input());
    }

    /**
     * The exercise that a program for a topic is written for: the one of that name, or the only one
     * there is, or the only one whose contract the source implements.
     *
     * @param id of the exercise; empty where it was not said
     * @throws IllegalArgumentException if there is none of that name on the topic, or several and
     *     none was named
     */
    public static Exercise exerciseOn(
            String topic, Optional<String> id, String source, List<Exercise> all) {
        List<Exercise> fit =
                all.stream()
                        .filter(one -> one.form() == Exercise.TaskKind.WRITE)
                        .filter(one -> one.topic().equals(topic))
                        .toList();
        String ids = fit.stream().map(Exercise::id).collect(Collectors.joining(", "));
        if (fit.isEmpty())
            throw new IllegalArgumentException(
                    "no exercise asks for a program on topic '" + topic + "'");
        List<Exercise> meant = fit.stream().filter(one -> implementsIts(source, one)).toList();
        if (id.isEmpty() && meant.size() == 1) return meant.get(0);
        if (id.isEmpty() && fit.size() > 1)
            throw new IllegalArgumentException(
                    "several exercises are on topic '%s'; name one with --exercise: %s"
                            .formatted(topic, ids));
        return fit.stream()
                .filter(one -> id.isEmpty() || id.get().equals(one.id()))
                .findFirst()
                .orElseThrow(
                        () ->
                                new IllegalArgumentException(
                                        "exercise '%s' asks for no program on topic '%s'; there are %s"
                                                .formatted(id.get(), topic, ids)));
    }

    /** Whether the exercise's contract stands behind {@code implements} in the source. */
    private static boolean implementsIts(String source, Exercise exercise) {
        String contract =
                exercise.contract()
                        .orElseGet(() -> Topics.named(exercise.topic()).contract().getSimpleName());
        String code = COMMENT.matcher(source).replaceAll(" ");
        return Pattern.compile("\\bimplements\\b[^{]*\\b" + Pattern.quote(contract) + "\\b")
                .matcher(code)
                .find();
    }
}
