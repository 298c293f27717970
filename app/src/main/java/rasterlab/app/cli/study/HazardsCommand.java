package rasterlab.app.cli.study;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.language.Texts;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.study.HazardMatrix;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.Topic;

/** The method × hazard table. */
@Command(
        name = "hazards",
        mixinStandardHelpOptions = true,
        description = {
            "Tries every method on every hazard of a topic and prints the verdicts.",
            "A verdict that differs from the recorded one is marked with ! and both are named.",
            "With --search it looks for a new input on which a method fails, and makes it simpler."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every verdict is the recorded one; the search has ended",
            "1:a verdict differs; a method of which no failure is known fails",
            "2:unknown topic or method, or a file that cannot be written"
        },
        footer = {
            "",
            "Example: ./lab hazards line",
            "Example: ./lab hazards line --search naive-textbook --out found.scene.json"
        })
public final class HazardsCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(arity = "0..1", paramLabel = "TOPIC", description = "only this one")
    private String topic;

    @Option(names = "--json", description = "prints one JSON object instead of tables")
    private boolean json;

    @Option(
            names = "--html",
            paramLabel = "FILE",
            description = {
                "writes a page with every verdict, its picture and the command that repeats it;",
                "without TOPIC, or where FILE does not end in .html, a folder of such pages"
            })
    private Path html;

    @Option(
            names = "--search",
            paramLabel = "METHOD",
            description = "a method or mutant of TOPIC to find a failing input for")
    private String searched;

    @Option(
            names = "--seconds",
            paramLabel = "N",
            description = "with --search: the longest it may take; default: ${DEFAULT-VALUE}")
    private int seconds = 60;

    @Option(
            names = "--seed",
            paramLabel = "S",
            description =
                    "with --search: the same numbers are drawn again; default: ${DEFAULT-VALUE}")
    private int seed = 1;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description =
                    "with --search: a scene file that ./lab run --scene, ./lab open and the lab read")
    private Path out;

    @Option(
            names = "--keep",
            description = "with --search: keeps it for the lab, where it is a chip of its topic")
    private boolean keep;

    public HazardsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
        if (searched != null)
            return new SearchRun(console, topic, searched, seed, out, keep).within(seconds, json);
        if (html != null) return new HazardPages(console, html).write(TopicChoice.of(topic));
        if (out != null) throw Complaint.badInput("--out goes with --search METHOD");
        if (keep) throw Complaint.badInput("--keep goes with --search METHOD");
        List<HazardMatrix> matrices = new ArrayList<>();
        for (Topic<?, ?, ?> chosen : TopicChoice.of(topic))
            matrices.add(HazardMatrix.judged(chosen, HazardTrial.WALL_LIMIT));
        Texts texts = console.language().texts();
        if (json) HazardMatrix.writeJson(matrices, console.out());
        else matrices.forEach(matrix -> HazardText.print(matrix, console.out(), texts));
        boolean asRecorded = matrices.stream().allMatch(HazardMatrix::asRecorded);
        return asRecorded ? ExitCode.DONE : ExitCode.FOUND_WRONG;
    }
}
