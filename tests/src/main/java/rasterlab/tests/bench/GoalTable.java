package rasterlab.tests.bench;

import java.io.PrintStream;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import rasterlab.tests.bench.language.BenchWords;

/**
 * The goals of one group beside what was measured.
 *
 * @param rounds the timings of each round, in which ours and the peer ran one after the other
 */
record GoalTable(List<Goal> goals, List<Map<Timing.Key, Timing>> rounds) {
    GoalTable {
        goals = List.copyOf(goals);
        rounds = List.copyOf(rounds);
    }

    /**
     * Writes one line for each goal: times of the middle round with their quartiles, the median of
     * the rounds' ratios with their range, and whether it is met.
     */
    void print(BenchWords words, PrintStream out) {
        out.println(words.head("head.raster"));
        for (Goal goal : goals) out.println(line(goal, words));
    }

    private record Pair(Timing ours, Timing peer) {
        double ratio() {
            return peer.median() / ours.median();
        }
    }

    private String line(Goal goal, BenchWords words) {
        List<Pair> pairs =
                rounds.stream()
                        .map(
                                round ->
                                        new Pair(
                                                timing(round, goal, goal.ours()),
                                                timing(round, goal, goal.peer())))
                        .sorted(Comparator.comparingDouble(Pair::ratio))
                        .toList();
        Pair middle = pairs.get(pairs.size() / 2);
        return String.format(
                Locale.ROOT,
                "%s | %s %s | %s %s | %.2f (%.2f–%.2f) | %.2f | %s",
                goal.work(),
                goal.ours(),
                quartiles(middle.ours()),
                goal.peer(),
                quartiles(middle.peer()),
                middle.ratio(),
                pairs.get(0).ratio(),
                pairs.get(pairs.size() - 1).ratio(),
                goal.ratio(),
                middle.ratio() >= goal.ratio() ? words.text("yes") : words.text("no"));
    }

    private static Timing timing(Map<Timing.Key, Timing> round, Goal goal, String method) {
        Timing timing = round.get(Timing.Key.of(goal.benchmark(), method, goal.parameters()));
        if (timing == null)
            throw new IllegalStateException(
                    "no measurement of "
                            + goal.benchmark().getSimpleName()
                            + "."
                            + method
                            + " at "
                            + goal.parameters());
        return timing;
    }

    private static String quartiles(Timing timing) {
        return String.format(
                Locale.ROOT, "%.1f (%.1f–%.1f)", timing.median(), timing.low(), timing.high());
    }
}
