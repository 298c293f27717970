package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import rasterlab.app.cli.console.Console;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.tour.Tour;
import rasterlab.engine.study.StudySettings;

/** Makes the tour. */
@Command(
        name = "tour",
        mixinStandardHelpOptions = true,
        description = {
            "Builds one page with every lab, charts, rendered scenes and graded submissions.",
            "No display is needed."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the page shows everything",
            "1:a part could not be made; the page says which and why",
            "2:the folder cannot be written to"
        },
        footer = {"", "Example: ./lab tour --out tour"})
final class TourCommand implements Callable<Integer> {
    private final Console console;

    @Option(
            names = "--out",
            paramLabel = "FOLDER",
            description = "where it goes; made if missing; default: ${DEFAULT-VALUE}",
            defaultValue = "rasterlab-tour")
    private Path folder;

    @Option(names = "--quick", description = "each lab in one language and one theme only")
    private boolean quick;

    @Option(
            names = "--untimed",
            hidden = true,
            description =
                    "with --quick: studies run each method once, for a look at everything else")
    private boolean untimed;

    TourCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        var tour = new Tour(folder, console.language().inWindow(), console.err());
        try {
            var timing = untimed ? StudySettings.shortest() : StudySettings.quick();
            boolean whole = quick ? tour.makeQuickly(home(), timing) : tour.make(home());
            console.out().println(tour.index().toAbsolutePath().normalize());
            return whole ? ExitCode.DONE : ExitCode.FOUND_WRONG;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw Complaint.gaveUp("interrupted");
        }
    }

    /** The folder of the ./lab script, which tells it. */
    private static Optional<Path> home() {
        return Optional.ofNullable(System.getProperty("rasterlab.home")).map(Path::of);
    }
}
