package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.sql.SQLException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import rasterlab.app.language.Language;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Grading.CaseSelection;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.runner.Judge;
import rasterlab.exercises.runner.JudgeSettings;
import rasterlab.exercises.score.GradingVerdict;
import rasterlab.exercises.score.Report;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Measures the grading server: single gradings from the source to the report, as a server makes
 * them when it has nothing else to do, without the way through the queue; then whole servers under
 * load, faults and kills.
 */
public final class GraderBench {
    private static final double GOAL_SECONDS = 0.7;
    private static final int WARM_UP = 3;
    private static final int MANY = 21;
    private static final int FEW = 5;

    /** The time after which a program that a server keeps in reserve has long started. */
    private static final long REST_SECONDS = 2;

    private final boolean quick;
    private final BenchWords words;
    private final MeasuredLines out;
    private final MeasuredLines err;
    private final Set<GraderPart> parts;
    private final long seed;

    /**
     * @param err for why a part fails
     * @param parts that are measured
     * @param seed of what is killed at random
     */
    public GraderBench(
            boolean quick,
            BenchWords words,
            PrintStream out,
            PrintStream err,
            Collection<GraderPart> parts,
            long seed) {
        this.quick = quick;
        this.words = words;
        this.out = new MeasuredLines(out);
        this.err = new MeasuredLines(err);
        this.parts = EnumSet.copyOf(parts);
        this.seed = seed;
    }

    /**
     * Prints the times of single gradings on each Java, of many one after another, and what a
     * server makes of a class, a burst and an attack, of faults of the machine and of kills. A part
     * that fails leaves the others.
     *
     * @return whether none failed
     */
    public boolean run() throws InterruptedException {
        boolean measured = true;
        for (var one : work().entrySet())
            if (!out.isOver()) measured &= isMeasured(one.getKey(), one.getValue());
        return measured;
    }

    /** Measures a part. */
    private interface PartWork {
        void run() throws IOException, InterruptedException, SQLException;
    }

    /** Lists the work in its order, by the names of the parts. */
    private Map<String, PartWork> work() {
        var work = new LinkedHashMap<String, PartWork>();
        if (parts.contains(GraderPart.SINGLE)) work.put(GraderPart.SINGLE.word(), this::single);
        Path home = Path.of(System.getProperty("rasterlab.home", "."));
        Set<GraderPart> loads = EnumSet.copyOf(GraderPart.LOADS);
        loads.retainAll(parts);
        if (!loads.isEmpty())
            work.put(
                    loads.stream().map(GraderPart::word).collect(Collectors.joining(", ")),
                    () -> new ServerBench(quick, words, out).run(home, loads));
        var faults = new FaultBench(home, quick, words, out);
        for (GraderPart part : parts)
            if (GraderPart.FAULTS.contains(part)) work.put(part.word(), () -> faults.run(part));
        if (parts.contains(GraderPart.KILLS))
            work.put(
                    GraderPart.KILLS.word(),
                    () -> new KillTrial(quick, seed, words, out).run(home));
        return work;
    }

    private boolean isMeasured(String name, PartWork work) throws InterruptedException {
        try {
            work.run();
            return true;
        } catch (IOException | SQLException | IllegalStateException failed) {
            err.println(sentence(name, failed, words));
            return false;
        }
    }

    /** Says in a line what failed, and where the logs of its servers are. */
    static String sentence(String part, Exception failed, BenchWords words) {
        String message = failed.getMessage();
        String said = message == null ? failed.toString() : message.strip().replaceAll("\\s+", " ");
        return failed instanceof LoggedFailure logged
                ? words.text("grader.failed.logs", part, said, logged.logs())
                : words.text("grader.failed", part, said);
    }

    private void single() throws IOException, InterruptedException {
        JudgeSettings plain = JudgeSettings.defaults();
        long start = System.nanoTime();
        try (Judge judge = Judge.start(plain.withImages(LabCall.IMAGES))) {
            out.println(words.text("grader.start", seconds(System.nanoTime() - start)));
            out.println(judge.isolation().describe(language()));
            measure(judge, "grader.image");
        }
        try (Judge judge = Judge.start(plain)) {
            measure(judge, "grader.jdk");
        }
    }

    private String language() {
        return words.language() == Language.RUSSIAN ? "ru" : "en";
    }

    private void measure(Judge judge, String key) throws InterruptedException {
        for (int k = 0; k < WARM_UP; k++) grade(judge);
        List<Long> idle = new ArrayList<>();
        for (int k = 0; k < (quick ? FEW : MANY); k++) {
            TimeUnit.SECONDS.sleep(REST_SECONDS);
            idle.add(grade(judge));
        }
        idle.sort(null);
        long median = idle.get(idle.size() / 2);
        boolean met = median <= GOAL_SECONDS * 1e9;
        out.println(
                words.text(
                        key,
                        seconds(median),
                        seconds(idle.get(0)),
                        seconds(idle.get(idle.size() - 1)),
                        String.valueOf(idle.size()),
                        String.valueOf(GOAL_SECONDS),
                        words.text(met ? "yes" : "no")));
        long start = System.nanoTime();
        int busy = quick ? FEW : MANY;
        for (int k = 0; k < busy; k++) grade(judge);
        out.println(
                words.text(
                        "grader.busy",
                        seconds((System.nanoTime() - start) / busy),
                        String.valueOf(busy)));
    }

    /** The nanoseconds from the source to the report. */
    private static long grade(Judge judge) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(BenchSources.EXERCISE);
        String source = BenchSources.right();
        long start = System.nanoTime();
        Report report = judge.grade(exercise, source, CaseSelection.all(7), one -> {});
        long nanos = System.nanoTime() - start;
        if (report.verdict() != GradingVerdict.OK)
            throw new IllegalStateException("expected a right program, got " + report.verdict());
        return nanos;
    }

    private static String seconds(long nanos) {
        return String.format(Locale.ROOT, "%.2f", nanos / 1e9);
    }
}
