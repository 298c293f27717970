package rasterlab.app.cli;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.folder.NewFolder;
import rasterlab.exercises.topic.TopicGradings;

/** Begins an exercise. */
@Command(
        name = "new",
        mixinStandardHelpOptions = true,
        description = {
            "Makes the folder of an exercise to begin with, which `./lab exercises validate` takes:",
            "cases of the topic's hazards, texts in English and Russian, a starter, a model solution.",
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

    ExercisesNewCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        if (!TopicGradings.names().contains(topic))
            throw Complaint.badInput(
                    "no exercise of topic '"
                            + topic
                            + "'; there are "
                            + String.join(", ", TopicGradings.names()));
        Path made = folder.toAbsolutePath().normalize();
        String id = made.getFileName() == null ? "" : made.getFileName().toString();
        if (!id.matches("[a-z0-9]+(-[a-z0-9]+)*"))
            throw Complaint.badInput(
                    folder + ": its last name must be lower-case words with hyphens");
        if (Files.exists(made)) throw Complaint.badInput(folder + ": is there already");
        Map<String, String> files = NewFolder.files(topic);
        WholeFile.requireFolder(made);
        files.forEach(
                (name, text) ->
                        WholeFile.write(made.resolve(name), text.getBytes(StandardCharsets.UTF_8)));
        console.out().println(console.language().texts().text("new", folder));
        return ExitCode.DONE;
    }
}
