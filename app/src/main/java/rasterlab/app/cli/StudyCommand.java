package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.study.StudyFile;
import rasterlab.app.study.StudyProgress;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;

/** Measures speed against accuracy. */
@Command(
        name = "study",
        mixinStandardHelpOptions = true,
        description = {
            "Measures every method of a topic: cost per item, timed and where it can be counted, against error.",
            "Prints a table, all its columns with --wide; --out writes a chart (.svg, .png)",
            "or the numbers (.csv, .json)."
        },
        footer = {"", "Example: ./lab study line --out line.svg --out line.csv"})
final class StudyCommand implements Callable<Integer> {
    private final Console console;

    @Parameters(index = "0", paramLabel = "TOPIC", description = "such as line")
    private String topic;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description = "file to write: .svg, .png, .csv or .json; may be given several times")
    private List<Path> files = List.of();

    @Option(names = "--quick", description = "fewer and shorter rounds, for a first look")
    private boolean quick;

    @Option(
            names = "--wide",
            description =
                    "also each workload's size and what was counted, in as many columns as it takes")
    private boolean wide;

    StudyCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        Topic<?, ?, ?> chosen = TopicChoice.one(topic);
        for (Path file : files) {
            StudyFile.named(file);
            WholeFile.requireWritable(file);
        }
        Study study = measured(chosen);
        var table = new StudyTable(study, console.language());
        (wide ? table.wide() : table.narrow()).forEach(console.out()::println);
        for (Path file : files) {
            StudyFile.write(study, file, console.language().inWindow());
            console.tell("wrote", file.toString());
        }
        return ExitCode.DONE;
    }

    private Study measured(Topic<?, ?, ?> chosen) {
        var settings = quick ? StudySettings.quick() : StudySettings.thorough();
        return StudyRunner.measure(
                chosen,
                settings,
                new StudyProgress(console.err(), console.language().inWindow())::show,
                Thread.currentThread()::isInterrupted);
    }
}
