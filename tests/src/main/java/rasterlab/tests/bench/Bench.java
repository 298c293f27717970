package rasterlab.tests.bench;

import java.io.IOException;
import java.io.PrintWriter;
import java.sql.SQLException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import rasterlab.app.cli.console.ComplaintText;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.engine.Topics;
import rasterlab.tests.bench.grader.GraderBench;
import rasterlab.tests.bench.grader.GraderPart;
import rasterlab.tests.bench.language.BenchWords;
import rasterlab.tests.bench.pipeline.PipelineBench;
import rasterlab.tests.bench.plan.FaceCounts;
import rasterlab.tests.bench.plan.PlanBench;
import rasterlab.tests.bench.study.StudyBench;
import rasterlab.tests.bench.window.WindowBench;

/** Measures the engine's methods beside their peers and prints the ratios. */
@Command(
        name = "./lab bench",
        mixinStandardHelpOptions = true,
        description = {
            "Times the methods beside their peers, such as Java2D and OpenGL, in one run. Prints both",
            "times, their ratio, its range over the rounds and the goal. It exits with 0 where a goal",
            "is missed, too."
        })
public final class Bench implements Callable<Integer> {
    private static final Map<String, Supplier<List<Goal>>> GROUPS =
            new TreeMap<>(Map.of("raster", RasterGoals::all));

    /** Times that every benchmark gets a process of its own, all benchmarks once in each round. */
    private static final int ROUNDS = 3;

    /**
     * The name of the part that is measured by a runner of its own, each line beside OpenGL in one
     * process.
     */
    private static final String PIPELINE = "pipeline";

    /** The name of the part that is measured in the real window. */
    private static final String WINDOW = "window";

    /** The name of the part that holds plans against the full pipeline. */
    private static final String PLAN = "plan";

    /** The name of the part that grades as the server does. */
    private static final String GRADER = "grader";

    /** The name of the part that tells what studies may be believed. */
    private static final String STUDY = "study";

    /** The name of the part that searches for failing inputs. */
    private static final String SEARCH = "search";

    @Spec private CommandSpec spec;

    @Parameters(
            paramLabel = "GROUP",
            description = "raster, pipeline, plan, search, study, window or grader")
    private String group;

    @Option(
            names = "--only",
            paramLabel = "TEXT",
            description = {
                "only the goals whose work has this text, such as \"segments\";",
                "for grader the names of parts with commas between them, such as disk,kills"
            })
    private String only = "";

    @Option(
            names = "--quick",
            description = "short rounds for a first look; quote figures of a whole run only")
    private boolean quick;

    @Option(
            names = "--minutes",
            paramLabel = "N",
            description = "window only: also N minutes of use, and what memory they left behind")
    private int minutes;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description =
                    "grader only: kills the same in the same order as a run that told this seed")
    private Long seed;

    @Option(
            names = "--lang",
            paramLabel = "LANGUAGE",
            description =
                    "language of the texts, en or ru; default: en; works have the same names in both")
    private ReportLanguage language = ReportLanguage.EN;

    private final Console console;
    private final BenchWords words;

    private Bench(Console console) {
        this.console = console;
        words = new BenchWords(console.language().inWindow());
    }

    public static void main(String[] arguments) {
        ReportLanguage language = ReportLanguage.asked(arguments);
        var console = Console.of(System.in, System.out, System.err, language);
        int code = commandLine(console).execute(arguments);
        console.out().flush();
        System.exit(code);
    }

    static CommandLine commandLine(Console console) {
        var bench = new Bench(console);
        var complaints = new ComplaintText(console.language());
        CommandLine command = bench.words.worn(new CommandLine(bench));
        return command.setOut(new PrintWriter(console.out(), true))
                .setErr(new PrintWriter(console.err(), true))
                .setExpandAtFiles(false)
                .registerConverter(ReportLanguage.class, ReportLanguage::named)
                .setParameterExceptionHandler(
                        (wrong, given) -> {
                            String name = command.getCommandName();
                            String see = bench.words.text("see", name);
                            console.err().println(name + ": " + complaints.of(wrong) + " " + see);
                            return CommandLine.ExitCode.USAGE;
                        });
    }

    /** The groups that can be measured; the {@code ./lab} scripts know these names too. */
    public static SortedSet<String> groups() {
        var names = new TreeSet<>(GROUPS.keySet());
        names.addAll(List.of(PIPELINE, PLAN, SEARCH, STUDY, WINDOW, GRADER));
        return names;
    }

    @Override
    public Integer call() throws RunnerException, IOException, InterruptedException, SQLException {
        requireSense();
        if (group.equals(WINDOW)) {
            new WindowBench(quick ? 1 : 5, quick ? 5 : 60, minutes, words, console.out()).run();
            return 0;
        }
        if (group.equals(SEARCH)) {
            var longest = Duration.ofSeconds(quick ? 10 : 60);
            boolean met = new SearchBench(longest, words, console.out()).run(Topics.all(), only);
            return met ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
        }
        if (group.equals(STUDY)) {
            new StudyBench(quick, words, console.out()).run();
            return 0;
        }
        if (group.equals(GRADER)) {
            boolean measured =
                    new GraderBench(quick, words, console.out(), console.err(), parts(), seed())
                            .run();
            return measured ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
        }
        if (group.equals(PLAN)) {
            new PlanBench(quick, words, console.out()).run();
            console.out().println();
            FaceCounts.print(words, console.out());
            return 0;
        }
        if (group.equals(PIPELINE)) {
            boolean measured =
                    new PipelineBench(quick, only, words, console.out(), console.err()).run();
            return measured ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
        }
        List<Goal> goals = goals();
        var rounds = new ArrayList<Map<Timing.Key, Timing>>();
        for (int round = 0; round < (quick ? 1 : ROUNDS); round++)
            rounds.add(timings(new Runner(options(goals).build()).run()));
        console.out().println();
        new GoalTable(goals, rounds).print(words, console.out());
        if (goals.stream().anyMatch(goal -> goal.benchmark() == CurveBenchmark.class)) {
            console.out().println();
            SegmentCounts.print(words, console.out());
        }
        return 0;
    }

    private void requireSense() {
        if (!groups().contains(group)) throw wrong("group", group, String.join(", ", groups()));
        if (minutes < 0) throw wrong("minutes.negative", String.valueOf(minutes));
        if (minutes > 0 && !group.equals(WINDOW)) throw wrong("minutes.group", group);
        if (!only.isEmpty() && List.of(PLAN, STUDY, WINDOW).contains(group))
            throw wrong("only.group");
        if (seed != null && !group.equals(GRADER)) throw wrong("seed.group", group);
        if (group.equals(GRADER)) {
            requireParts();
            return;
        }
        List<String> works = works();
        if (works.stream().anyMatch(work -> work.contains(only))) return;
        List<String> near = group.equals(SEARCH) ? SearchBench.worksOfTopicIn(only) : works;
        throw near.isEmpty()
                ? wrong("only.topics", only, String.join("; ", SearchBench.topics()))
                : wrong("only.none", only, String.join("; ", near));
    }

    private Set<GraderPart> parts() {
        return isGiven("--only") ? GraderPart.in(only) : GraderPart.all();
    }

    private long seed() {
        return seed == null ? System.nanoTime() : seed;
    }

    private boolean isGiven(String option) {
        return spec.commandLine().getParseResult().hasMatchedOption(option);
    }

    private void requireParts() {
        if (!isGiven("--only")) return;
        String known = String.join(", ", GraderPart.words());
        GraderPart.unknownIn(only)
                .ifPresent(
                        name -> {
                            throw wrong("only.parts", name, known);
                        });
    }

    /**
     * The works that {@code --only} chooses from; empty text alone for the group that has no
     * choice.
     */
    private List<String> works() {
        if (List.of(PLAN, STUDY, WINDOW).contains(group)) return List.of("");
        if (group.equals(SEARCH)) return SearchBench.works();
        if (group.equals(PIPELINE)) return PipelineBench.works();
        return GROUPS.get(group).get().stream().map(Goal::work).toList();
    }

    private List<Goal> goals() {
        return GROUPS.get(group).get().stream().filter(goal -> goal.work().contains(only)).toList();
    }

    private ParameterException wrong(String key, Object... arguments) {
        return new ParameterException(spec.commandLine(), words.text(key, arguments));
    }

    private ChainedOptionsBuilder options(List<Goal> goals) {
        ChainedOptionsBuilder options =
                new OptionsBuilder()
                        .forks(1)
                        .shouldFailOnError(true)
                        .warmupIterations(quick ? 2 : 4)
                        .warmupTime(TimeValue.milliseconds(200))
                        .measurementIterations(quick ? 3 : 6)
                        .measurementTime(TimeValue.milliseconds(quick ? 200 : 250));
        var names = new LinkedHashSet<String>();
        for (Goal goal : goals)
            for (String method : List.of(goal.ours(), goal.peer()))
                names.add(Pattern.quote(goal.benchmark().getName() + "." + method) + "$");
        names.forEach(options::include);
        return options;
    }

    private static Map<Timing.Key, Timing> timings(Iterable<RunResult> results) {
        var timings = new HashMap<Timing.Key, Timing>();
        for (RunResult result : results) timings.put(Timing.key(result), Timing.of(result));
        return timings;
    }
}
