package rasterlab.app.cli.exercise;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.canvas.file.ShellPath;
import rasterlab.app.cli.console.Console;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.engine.naming.Named;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.folder.CopiedFolder;
import rasterlab.exercises.folder.NewFolder;
import rasterlab.exercises.topic.TopicGradings;

/** Begins an exercise. */
@Command(
        name = "new",
        mixinStandardHelpOptions = true,
        description = {
            "Makes the folder of a new exercise to begin with.",
            "It is valid: cases of the topic's hazards, texts in both languages, starter and model.",
            "For the kinds break and predict it is a copy of the course's own exercise on the topic.",
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the folder is made",
            "2:no exercise can be made of that topic, or the folder is there or cannot be made",
        },
        footer = {"", "Example: ./lab exercises new circle my-exercises/my-circle"})
final class ExercisesNewCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", paramLabel = "TOPIC", description = "such as circle")
    private String topic;

    @Parameters(
            index = "1",
            paramLabel = "DIR",
            description = "the folder to make; its name, lower-case words with hyphens, is the ID")
    private Path folder;

    @Option(
            names = "--kind",
            paramLabel = "KIND",
            description =
                    "write, break or predict: whether a program is written, inputs are found or"
                            + " steps are predicted; default: write")
    private String kind = "write";

    ExercisesNewCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        TaskKind form = form();
        List<String> topics =
                form == TaskKind.WRITE ? TopicGradings.names() : CopiedFolder.topics(form);
        if (!topics.contains(topic))
            throw Complaint.badInput(Named.unknown("exercise of topic", topic, topics));
        Path made = folder.toAbsolutePath().normalize();
        String id = made.getFileName() == null ? "" : made.getFileName().toString();
        if (!id.matches("[a-z0-9]+(-[a-z0-9]+)*"))
            throw Complaint.badInput(
                    folder + ": its last name must be lower-case words with hyphens");
        if (Files.exists(made)) throw Complaint.badInput(folder + ": is there already");
        Map<String, byte[]> files = files(form, id);
        WholeFile.requireFolder(made);
        files.forEach((name, content) -> WholeFile.write(made.resolve(name), content));
        String key = form == TaskKind.WRITE ? "new" : "new.copy";
        String prove = "./lab exercises prove " + id + " --exercises " + ShellPath.quoted(parent());
        console.out().println(console.language().texts().text(key, folder, prove));
        return ExitCode.DONE;
    }

    private Path parent() {
        Path parent = folder.normalize().getParent();
        return parent == null ? Path.of(".") : parent;
    }

    private TaskKind form() {
        List<String> kinds =
                Stream.of(TaskKind.values())
                        .map(each -> each.name().toLowerCase(Locale.ROOT))
                        .toList();
        if (!kinds.contains(kind)) throw Complaint.badInput(Named.unknown("kind", kind, kinds));
        return TaskKind.valueOf(kind.toUpperCase(Locale.ROOT));
    }

    private Map<String, byte[]> files(TaskKind form, String id) {
        if (form != TaskKind.WRITE) return CopiedFolder.files(topic, form, id).orElseThrow();
        Map<String, byte[]> files = new LinkedHashMap<>();
        NewFolder.files(topic)
                .forEach((name, text) -> files.put(name, text.getBytes(StandardCharsets.UTF_8)));
        return files;
    }
}
