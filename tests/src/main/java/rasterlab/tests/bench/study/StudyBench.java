package rasterlab.tests.bench.study;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import rasterlab.app.Main;
import rasterlab.engine.study.Ranking;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.measuring.PaceComparison.Order;
import rasterlab.tests.bench.language.BenchWords;
import rasterlab.tests.process.JavaCommand;

/**
 * Prints how far a quick study may be believed: its own repetition, a known difference, and load.
 */
public final class StudyBench {
    /** A topic whose quick study takes seconds. */
    private static final String TOPIC = "shade";

    private static final int BUSY = 8;

    private static final String USUAL = "bresenham";
    private static final double LEAST_TAU = 0.9;
    private static final double SLOWED_FOUND = 0.95;

    private final int calm;
    private final int repeated;
    private final BenchWords words;
    private final PrintStream out;

    /**
     * @param quick for a first look, with fewer runs
     */
    public StudyBench(boolean quick, BenchWords words, PrintStream out) {
        calm = quick ? 2 : 4;
        repeated = quick ? 4 : 20;
        this.words = words;
        this.out = out;
    }

    /** Measures and prints, a line for each figure. */
    public void run() throws IOException, InterruptedException {
        out.println(words.machine());
        out.println(words.text("study.load", load()));
        out.println(words.head("head.study"));
        List<StudyRun> runs = runs(calm);
        printRepetition(runs);
        printSlowed();
        try (var busy = new BusyProcesses(BUSY)) {
            printBusy(busy.running(), agreed(runs), runs(repeated));
        }
        out.println(words.text("study.load", load()));
    }

    private static String load() {
        return String.format(
                Locale.ROOT,
                "%.1f",
                ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
    }

    /** Studies of the topic, each in a process of its own. */
    private static List<StudyRun> runs(int count) throws IOException, InterruptedException {
        var runs = new ArrayList<StudyRun>();
        Path file = Files.createTempFile("rasterlab", ".json");
        for (int i = 0; i < count; i++) {
            List<String> call =
                    List.of(
                            "study",
                            TOPIC,
                            "--quick",
                            "--seed",
                            String.valueOf(i),
                            "--out",
                            file.toString());
            Process study =
                    new ProcessBuilder(JavaCommand.of(List.of(), Main.class.getName(), call))
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .redirectError(ProcessBuilder.Redirect.DISCARD)
                            .start();
            if (study.waitFor() != 0) throw new IOException("./lab " + String.join(" ", call));
            runs.add(StudyRun.of(new ObjectMapper().readTree(file.toFile())));
        }
        Files.delete(file);
        return runs;
    }

    private void printRepetition(List<StudyRun> runs) {
        double tau = 1;
        double near = 1;
        long both = 0;
        long pairs = 0;
        for (int i = 0; i < runs.size(); i++)
            for (int j = 0; j < i; j++) {
                tau = Math.min(tau, runs.get(i).tau(runs.get(j)));
                near = Math.min(near, runs.get(i).near(runs.get(j)));
                both += runs.get(i).bothTold(runs.get(j));
                pairs += runs.get(i).pairs();
            }
        String said = words.text("study.tau", percent(both, pairs));
        if (both == 0) printNothingTold(said, number(LEAST_TAU));
        else print(said, number(tau), number(LEAST_TAU), tau >= LEAST_TAU);
        print(words.text("study.near"), number(near), number(1), near >= 1);
    }

    private void printSlowed() {
        var topic = new SlowedLines(USUAL);
        var slower = new int[topic.workloads().size()];
        var faster = 0;
        for (int run = 0; run < repeated; run++) {
            StudySettings settings = StudySettings.quick().withSeed(run);
            Study study = StudyRunner.measure(topic, settings, step -> {}, () -> false);
            List<Ranking> rankings = Ranking.all(study);
            for (int i = 0; i < rankings.size(); i++) {
                boolean first = rankings.get(i).places().get(0).method().equals(SlowedLines.SLOWED);
                Order order = rankings.get(i).toNext(0).order();
                boolean told = order == Order.FASTER || order == Order.SLOWER;
                if (told && first) faster++;
                if (told && !first) slower[i]++;
            }
        }
        double goal = SLOWED_FOUND * repeated;
        for (int i = 0; i < slower.length; i++)
            print(
                    words.text("study.slowed", topic.workloads().get(i).name()),
                    slower[i] + "/" + repeated,
                    number(goal),
                    slower[i] >= goal);
        print(words.text("study.slowed.wrong"), String.valueOf(faster), "0", faster == 0);
    }

    /** The pairs that a run tells apart and no other run puts in the opposite order. */
    private static Set<StudyRun.Faster> agreed(List<StudyRun> runs) {
        var agreed = new LinkedHashSet<StudyRun.Faster>();
        for (StudyRun run : runs) agreed.addAll(run.told());
        agreed.removeIf(one -> runs.stream().anyMatch(run -> run.told().contains(one.reversed())));
        return agreed;
    }

    private void printBusy(long busy, Set<StudyRun.Faster> known, List<StudyRun> runs) {
        long told = 0;
        long wrong = 0;
        long pairs = 0;
        for (StudyRun run : runs) {
            told += run.told().size();
            pairs += run.pairs();
            wrong += run.told().stream().filter(one -> known.contains(one.reversed())).count();
        }
        String said = words.text("study.busy", String.valueOf(busy), percent(told, pairs));
        if (told == 0) printNothingTold(said, "0");
        else print(said, wrong + "/" + told, "0", wrong == 0);
    }

    /** A line of a goal that no pair says anything about. */
    private void printNothingTold(String said, String goal) {
        out.printf("%s | - | %s | %s%n", said, goal, words.text("study.nothing"));
    }

    private void print(String said, String measured, String goal, boolean met) {
        out.printf("%s | %s | %s | %s%n", said, measured, goal, words.text(met ? "yes" : "no"));
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }

    private static String percent(long part, long of) {
        return String.valueOf(Math.round(100.0 * part / Math.max(1, of)));
    }
}
