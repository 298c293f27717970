package rasterlab.app.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.study.StudyCounts;
import rasterlab.app.study.StudyFile;
import rasterlab.app.study.StudyProgress;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Measurement;
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
            "Prints a table; --out writes a chart (.svg, .png) or the numbers (.csv, .json)."
        },
        footer = {"", "Example: ./lab study line --out line.svg --out line.csv"})
final class StudyCommand implements Callable<Integer> {
    /** What a method that did not end or crashed has instead of numbers. */
    private static final String NOT_TIMED = "–";

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
            names = "--lang",
            paramLabel = "LANGUAGE",
            description = "of the chart: en or ru; default: en")
    private ReportLanguage language = ReportLanguage.EN;

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
        table(study).lines().forEach(console.out()::println);
        for (Path file : files) {
            StudyFile.write(study, file, language.inWindow());
            console.err().println("wrote " + file);
        }
        return ExitCode.DONE;
    }

    private Study measured(Topic<?, ?, ?> chosen) {
        var settings = quick ? StudySettings.quick() : StudySettings.thorough();
        return StudyRunner.measure(
                chosen,
                settings,
                new StudyProgress(console.err())::show,
                Thread.currentThread()::isInterrupted);
    }

    static TextTable table(Study study) {
        StudyCounts counts = StudyCounts.of(study);
        var heads = new ArrayList<String>(List.of("method", "workload", "size"));
        heads.add("ns/" + study.item());
        heads.add("spread");
        counts.names().forEach(name -> heads.add(name + "/" + study.item()));
        heads.addAll(List.of("error [" + study.errorUnit() + "]", "wrong", "verdict"));
        var table = new TextTable(heads);
        for (Measurement measured : study.measurements()) table.add(row(measured, counts));
        return table;
    }

    private static List<String> row(Measurement measured, StudyCounts counts) {
        Cost cost = measured.cost();
        Deviation error = measured.error();
        var row = new ArrayList<String>(List.of(measured.method(), measured.workload()));
        row.add(String.valueOf(measured.size()));
        row.add(cost.timed() ? number(cost.medianNanos()) : NOT_TIMED);
        row.add(
                cost.timed()
                        ? number(cost.lowNanos()) + "–" + number(cost.highNanos())
                        : NOT_TIMED);
        counts.cells(measured).forEach(cell -> row.add(shortened(cell)));
        row.add(cost.timed() ? rounded(error.worst()) : NOT_TIMED);
        row.add(cost.timed() ? String.valueOf(error.missing() + error.extra()) : NOT_TIMED);
        row.add(measured.kind().code());
        return row;
    }

    private static String shortened(String count) {
        return count.contains(".") ? number(Double.parseDouble(count)) : count;
    }

    /** Two places, or two digits where those would be 0. */
    private static String number(double value) {
        String form = value == 0 || value >= 0.01 ? "%.2f" : "%.1e";
        return String.format(Locale.ROOT, form, value);
    }

    /** Three digits; the files have all. */
    private static String rounded(double error) {
        if (error == 0) return "0";
        String form = error >= 0.001 && error < 1000 ? "%.3f" : "%.2e";
        return Double.isFinite(error)
                ? String.format(Locale.ROOT, form, error)
                : String.valueOf(error);
    }
}
