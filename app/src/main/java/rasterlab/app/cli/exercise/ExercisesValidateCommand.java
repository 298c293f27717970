package rasterlab.app.cli.exercise;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.Failures;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.folder.FolderCheck;
import rasterlab.exercises.score.Phrase;

/** Checks an exercise's folder. */
@Command(
        name = "validate",
        mixinStandardHelpOptions = true,
        description = {
            "Says all that is wrong in an exercise's folder at once, a line each: file, place, reason.",
            "Starter and model solution are compiled, but not run. A folder of such folders will do.",
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:nothing is wrong",
            "1:something is",
            "2:there is no such folder, or no exercise in it",
        },
        footer = {"", "Example: ./lab exercises validate my-exercises/my-circle"})
final class ExercisesValidateCommand implements Callable<Integer> {
    private static final String FILE = "exercise.json";

    private final Console console;

    @Parameters(index = "0", paramLabel = "DIR", description = "the folder")
    private Path folder;

    ExercisesValidateCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        int found = 0;
        for (Path one : folders()) {
            List<Phrase> faults = FolderCheck.faults(one);
            for (Phrase fault : faults)
                console.out().println(Failures.oneLine(fault.in(console.language().code())));
            if (faults.isEmpty())
                console.out().println(console.language().texts().text("valid", one));
            tellOfBuiltIn(one.toAbsolutePath().normalize());
            found += faults.size();
        }
        return found == 0 ? ExitCode.DONE : ExitCode.FOUND_WRONG;
    }

    private void tellOfBuiltIn(Path one) {
        String id = String.valueOf(one.getFileName());
        if (Catalogue.builtIn().ids().contains(id)) console.tell("replaced", id, one.getParent());
    }

    /** The folder itself, or those in it where it holds no exercise but folders of such. */
    private List<Path> folders() {
        if (!Files.isDirectory(folder))
            throw Complaint.badInput(
                    Files.exists(folder)
                            ? folder + ": is not a folder"
                            : folder + ": no such folder");
        if (Files.exists(folder.resolve(FILE))) return List.of(folder);
        List<Path> inside = new ArrayList<>();
        try (Stream<Path> entries = Files.list(folder)) {
            entries.sorted().filter(one -> Files.exists(one.resolve(FILE))).forEach(inside::add);
        } catch (IOException e) {
            throw Complaint.badInput(folder + ": " + WholeFile.reason(e));
        }
        return inside.isEmpty() ? List.of(folder) : inside;
    }
}
