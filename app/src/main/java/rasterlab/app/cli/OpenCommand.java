package rasterlab.app.cli;

import java.awt.GraphicsEnvironment;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.exercise.ExercisesOption;
import rasterlab.app.cli.exercise.SourceFile;
import rasterlab.app.language.Language;
import rasterlab.app.model.SceneText;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.shell.WindowStart;
import rasterlab.app.shell.labs.FirstCase;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.scene.MethodCase;

/** Opens the window with a failed case in the lab of its topic. */
@Command(
        name = "open",
        mixinStandardHelpOptions = true,
        description = {
            "Opens the desktop lab with the case of an exercise, drawn by the right method.",
            "With --with your program is drawn beside it: drag the input, step through both.",
            "It is the text of its exercise, too; the text kept there stays as another draft."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the window was opened",
            "2:a file or an exercise is wrong, or there is no display"
        },
        footer = {
            "",
            "Example: ./lab open check-line-bresenham/steep.scene.json --with Bresenham.java"
        })
final class OpenCommand implements Callable<Integer> {
    /** Opens a window in a language, if one was asked for, with a case. */
    @FunctionalInterface
    interface Opening {
        void open(Optional<Language> asked, FirstCase first);
    }

    private final Console console;
    private final BooleanSupplier display;
    private final Opening opening;
    @Spec private CommandSpec spec;

    @Parameters(
            index = "0",
            paramLabel = "FILE",
            description =
                    "a scene file that a result or `./lab check` gives, such as steep.scene.json")
    private Path file;

    @Option(
            names = "--with",
            paramLabel = "SOURCE",
            description = "your Java source, compiled and run as `./lab check` does it")
    private Path source;

    @Option(
            names = "--exercise",
            paramLabel = "EXERCISE",
            description =
                    "what the source was written for; may be left out where a topic has one only,"
                            + " or the interface that it implements tells")
    private String exercise;

    @Mixin private ExercisesOption exercises;

    OpenCommand(Console console) {
        this(
                console,
                () -> !GraphicsEnvironment.isHeadless(),
                (asked, first) -> WindowStart.open(asked, console.err(), Optional.of(first)));
    }

    /**
     * @param display whether there is one
     */
    OpenCommand(Console console, BooleanSupplier display, Opening opening) {
        this.console = console;
        this.display = display;
        this.opening = opening;
    }

    @Override
    public Integer call() {
        MethodCase scene = SceneText.methodCase(file);
        if (source == null && (exercise != null || exercises.isGiven()))
            throw Complaint.badInput("--exercise and --exercises go with --with SOURCE");
        FirstCase first = first(scene, program(scene.topic()));
        if (!display.getAsBoolean())
            throw Complaint.badInput(
                    "there is no display; `./lab run --scene "
                            + file
                            + "` prints what is right there");
        opening.open(language(), first);
        return ExitCode.DONE;
    }

    private FirstCase first(MethodCase scene, Optional<FirstCase.WrittenSource> program) {
        try {
            return new FirstCase(scene, program);
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(file + ": " + e.getMessage());
        }
    }

    private Optional<FirstCase.WrittenSource> program(String topic) {
        if (source == null) return Optional.empty();
        List<Exercise> all = exercises.catalogue(console).all();
        try {
            String text = SourceFile.read(source);
            var written = FirstCase.exerciseOn(topic, Optional.ofNullable(exercise), text, all);
            String name = String.valueOf(source.getFileName());
            return Optional.of(new FirstCase.WrittenSource(written, text, name));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    /** The window's own language is kept unless another is asked for. */
    private Optional<Language> language() {
        boolean asked =
                spec.commandLine().getParseResult().hasMatchedOption(LabCommand.LANGUAGE)
                        || spec.root()
                                .commandLine()
                                .getParseResult()
                                .hasMatchedOption(LabCommand.LANGUAGE);
        return asked ? Optional.of(console.language().inWindow()) : Optional.empty();
    }
}
