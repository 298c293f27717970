package rasterlab.app.cli.study;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.exercise.ExercisesOption;
import rasterlab.app.cli.exercise.SourceFile;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.shell.labs.FirstCase;
import rasterlab.app.study.OwnStudy;
import rasterlab.engine.study.Progress;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;
import rasterlab.exercises.Exercise;

/** The user's own program as one more method of a study. */
final class OwnSource {
    @Option(
            names = "--with",
            paramLabel = "SOURCE",
            description = "your Java source as one more method, run as `./lab check` does it")
    private Path source;

    @Option(
            names = "--exercise",
            paramLabel = "EXERCISE",
            description =
                    "what the source was written for; may be left out where a topic has one only,"
                            + " or the interface that it implements tells")
    private String exercise;

    @Mixin private ExercisesOption exercises;

    boolean isGiven() {
        return source != null;
    }

    /** Passes unless options are given that go with a source alone. */
    void requireSource() {
        if (source == null && (exercise != null || exercises.isGiven()))
            throw Complaint.badInput("--exercise and --exercises go with --with SOURCE");
    }

    /**
     * The study of a topic with the program among its methods.
     *
     * @throws Complaint if the source cannot be read, is for no exercise on the topic, or cannot
     *     run
     */
    Study measured(
            Topic<?, ?, ?> topic,
            StudySettings settings,
            Console console,
            Consumer<Progress> progress,
            BooleanSupplier cancelled) {
        String text = SourceFile.read(source);
        try (var own = new OwnMethods()) {
            own.bring(written(topic.name(), text, console), text);
            OwnProgram program = own.of(topic.name()).orElseThrow();
            Optional<String> obstacle = program.obstacle();
            if (obstacle.isPresent()) throw Complaint.badInput(obstacle.get());
            return new OwnStudy<>(topic, program, own).measure(settings, progress, cancelled);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            throw Complaint.gaveUp("your program was ended from outside");
        }
    }

    /** Why the program gave no answer, a line for each reason; none where it answered all. */
    static List<String> refusals(Study study, Language language) {
        return study.measurements().stream()
                .filter(one -> !one.isAnswered())
                .flatMap(one -> OwnWords.refusal(one.method(), one.detail(), language).stream())
                .distinct()
                .toList();
    }

    private Exercise written(String topic, String text, Console console) {
        try {
            return FirstCase.exerciseOn(
                    topic, Optional.ofNullable(exercise), text, exercises.catalogue(console).all());
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }
}
