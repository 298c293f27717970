package rasterlab.app.cli.study;

import java.math.BigDecimal;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.OptionNumbers;
import rasterlab.app.findings.Findings;
import rasterlab.app.outcome.Complaint;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.study.ShippedStudies;
import rasterlab.app.study.StudyCost;
import rasterlab.app.study.StudyFile;
import rasterlab.app.study.StudyProgress;
import rasterlab.app.study.front.StudyPlot;
import rasterlab.engine.naming.Named;
import rasterlab.engine.study.Progress;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;

/** Measures speed against accuracy. */
@Command(
        name = "study",
        mixinStandardHelpOptions = true,
        description = {
            "Compares all methods of a topic: cost per item (time and, where possible, operations) and error.",
            "Prints a table, all its columns with --wide; --out writes a chart (.svg, .png)",
            "or the numbers (.csv, .json; every round is in the last).",
            "Methods take turns until they can be told apart or time runs out; then it says which",
            "cannot be told apart, and how many rounds would settle it. Ctrl-C keeps what was measured."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the methods were compared",
            "1:with --all, a topic has no page, and its reason was printed; with --ship, it was stopped",
            "2:an argument is wrong, or a file cannot be written"
        },
        footer = {
            "",
            "Example: ./lab study line --out line.svg --out line.csv",
            "         ./lab study line --with Bresenham.java --out line.svg",
            "         ./lab study --all --quick --out findings"
        })
public final class StudyCommand implements Callable<Integer> {
    /** A day, in seconds: nobody waits longer. */
    private static final double LONGEST = 86_400;

    private final Console console;

    @Parameters(
            index = "0",
            arity = "0..1",
            paramLabel = "TOPIC",
            description = "such as line; none with --all")
    private Optional<String> topic = Optional.empty();

    @Option(
            names = "--all",
            description =
                    "all topics: --out DIR gets a page for each, with charts, sentences computed"
                            + " from the numbers and the commands that repeat them")
    private boolean all;

    @Option(
            names = "--out",
            paramLabel = "FILE",
            description = "file to write: .svg, .png, .csv or .json; may be given several times")
    private List<Path> files = List.of();

    @Option(
            names = "--ship",
            paramLabel = "DIR",
            description =
                    "for who builds Rasterlab: each topic's result there, as it comes with the"
                            + " program and its tab shows it before anything was measured")
    private Optional<Path> ship = Optional.empty();

    @Option(names = "--quick", description = "fewer and shorter rounds, for a first look")
    private boolean quick;

    @Option(
            names = "--wide",
            description =
                    "also each workload's size and what was counted, in as many columns as it takes")
    private boolean wide;

    @Option(
            names = "--rounds",
            converter = OptionNumbers.FromOne.class,
            paramLabel = "N",
            description = "timed rounds of each method, at least 1")
    private Optional<Integer> rounds = Optional.empty();

    @Option(
            names = "--seconds",
            paramLabel = "S",
            description = "time for the rounds of all methods; 0: just the rounds")
    private Optional<Double> seconds = Optional.empty();

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "seed of the order in which methods take turns")
    private Optional<Long> seed = Optional.empty();

    @Option(
            names = "--cost",
            paramLabel = "time|operations|parts",
            description =
                    "what the chart shows and rows are sorted by; operations are counted, free of"
                            + " noise; parts are what answers are made of, where methods choose how"
                            + " many: the segments of a curve")
    private String cost = StudyCost.TIME.code();

    @Option(
            names = "--chart",
            paramLabel = "CHART",
            description =
                    "what --out draws: front (speed against accuracy, the default), sizes,"
                            + " cost-growth, error-growth or error-by-input (with the method that"
                            + " is best in each range of sizes)")
    private String chart = StudyPlot.FRONT.code();

    @Mixin private OwnSource own;

    public StudyCommand(Console console) {
        this.console = console;
    }

    @Override
    public Integer call() {
        if (ship.isPresent()) return shipped(ship.get());
        if (all) return findings();
        own.requireSource();
        if (topic.isEmpty()) throw Complaint.badInput("name a TOPIC, or all of them with --all");
        Topic<?, ?, ?> chosen = TopicChoice.one(topic.get());
        for (Path file : files) {
            StudyFile.named(file);
            WholeFile.requireWritable(file);
        }
        StudySettings settings = settings();
        StudyCost shownCost = cost(chosen);
        StudyPlot plot = plot();
        try (var stop = new StopRequest()) {
            Study study = measured(chosen, settings, stop);
            var table = new StudyTable(study, console.language());
            (wide ? table.wide() : table.narrow()).forEach(console.out()::println);
            OwnSource.refusals(study, console.language().inWindow())
                    .forEach(console.out()::println);
            new RankingText(shownCost.of(study), shownCost, console.language())
                    .lines()
                    .forEach(console.out()::println);
            for (Path file : files) {
                StudyFile.write(study, plot, shownCost, file, console.language().inWindow());
                console.tell("wrote", file.toString());
            }
            console.out().flush();
        }
        return ExitCode.DONE;
    }

    private int shipped(Path folder) {
        requireOneOrAll();
        if (topic.isEmpty() && !all) throw Complaint.badInput("--ship DIR needs TOPIC or --all");
        if (own.isGiven()) throw Complaint.badInput("--with SOURCE does not go with --ship DIR");
        if (!files.isEmpty()) throw Complaint.badInput("--out does not go with --ship DIR");
        StudySettings settings = settings();
        WholeFile.requireFolder(folder);
        try (var stop = new StopRequest()) {
            for (Topic<?, ?, ?> one : TopicChoice.of(topic.orElse(null))) {
                Study study = measured(one, settings, stop);
                if (!study.isWhole()) return ExitCode.FOUND_WRONG;
                console.tell("wrote", ShippedStudies.write(study, folder).toString());
            }
        }
        return ExitCode.DONE;
    }

    private void requireOneOrAll() {
        if (all && topic.isPresent())
            throw Complaint.badInput("--all is all topics, '" + topic.get() + "' is one");
    }

    private int findings() {
        requireOneOrAll();
        if (own.isGiven()) throw Complaint.badInput("--with SOURCE goes with one TOPIC");
        if (files.size() != 1)
            throw Complaint.badInput("--all needs one folder for its pages: --out DIR");
        try (var stop = new StopRequest()) {
            var findings =
                    new Findings(
                            files.get(0),
                            settings(),
                            pace(quick, rounds, seconds),
                            console.language().inWindow(),
                            console.err()::println,
                            stop::isMade);
            boolean whole = findings.write(TopicChoice.of(null));
            console.tell("wrote", findings.index().toString());
            return whole ? ExitCode.DONE : ExitCode.FOUND_WRONG;
        }
    }

    /** The options that ask for such settings, each behind a space. */
    static String pace(boolean quick, Optional<Integer> rounds, Optional<Double> seconds) {
        return (quick ? " --quick" : "")
                + rounds.map(number -> " --rounds " + number).orElse("")
                + seconds.map(
                                number ->
                                        " --seconds "
                                                + BigDecimal.valueOf(number)
                                                        .stripTrailingZeros()
                                                        .toPlainString())
                        .orElse("");
    }

    private StudySettings settings() {
        StudySettings settings = quick ? StudySettings.quick() : StudySettings.thorough();
        if (rounds.isPresent()) {
            if (rounds.get() < 1)
                throw Complaint.badInput("--rounds must be at least 1, got " + rounds.get());
            settings = settings.withRounds(rounds.get());
        }
        if (seconds.isPresent()) {
            double budget = seconds.get();
            if (!(budget >= 0 && budget <= LONGEST))
                throw Complaint.badInput(
                        "--seconds must be from 0 to " + (int) LONGEST + ", got " + budget);
            settings = settings.withBudget(Duration.ofMillis(Math.round(1000 * budget)));
        }
        return seed.map(settings::withSeed).orElse(settings);
    }

    private StudyPlot plot() {
        return Stream.of(StudyPlot.values())
                .filter(one -> one.code().equals(chart))
                .findFirst()
                .orElseThrow(
                        () -> Complaint.badInput(Named.unknown("chart", chart, StudyPlot.codes())));
    }

    private StudyCost cost(Topic<?, ?, ?> chosen) {
        StudyCost named =
                Stream.of(StudyCost.values())
                        .filter(one -> one.code().equals(cost))
                        .findFirst()
                        .orElseThrow(
                                () ->
                                        Complaint.badInput(
                                                "--cost must be one of "
                                                        + String.join(", ", StudyCost.codes())
                                                        + ", got '"
                                                        + cost
                                                        + "'"));
        if (named.isPossible(chosen)) return named;
        throw Complaint.badInput(
                named == StudyCost.PARTS
                        ? "no method chooses of how many parts an answer is made in topic '"
                                + chosen.name()
                                + "'"
                        : "nothing is counted in topic '" + chosen.name() + "'");
    }

    private Study measured(Topic<?, ?, ?> chosen, StudySettings settings, StopRequest stop) {
        Consumer<Progress> progress =
                new StudyProgress(console.err(), console.language().inWindow())::show;
        BooleanSupplier cancelled = () -> stop.isMade() || Thread.currentThread().isInterrupted();
        return own.isGiven()
                ? own.measured(chosen, settings, console, progress, cancelled)
                : StudyRunner.measure(chosen, settings, progress, cancelled);
    }
}
