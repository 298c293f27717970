package rasterlab.app.cli.study;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.language.Texts;
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
            "A verdict that differs from the recorded one is marked with ! and both are named."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every verdict is the recorded one",
            "1:a verdict differs",
            "2:unknown topic"
        },
        footer = {"", "Example: ./lab hazards line"})
public final class HazardsCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(arity = "0..1", paramLabel = "TOPIC", description = "only this one")
    private String topic;

    @Option(names = "--json", description = "prints one JSON object instead of tables")
    private boolean json;

    public HazardsCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() throws IOException {
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
