package rasterlab.tests.bench;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The goals of one group beside what was measured. */
record GoalTable(List<Goal> goals, Map<Timing.Key, Timing> timings) {
    GoalTable {
        goals = List.copyOf(goals);
        timings = Map.copyOf(timings);
    }

    /**
     * Writes one line for each goal: times with their quartiles, the ratio, and whether it is met.
     */
    void print(PrintStream out) {
        out.println("work | ours, ns | peer, ns | ratio | goal | met");
        out.println("--- | --- | --- | --- | --- | ---");
        for (Goal goal : goals) out.println(line(goal));
    }

    private String line(Goal goal) {
        Timing ours = timing(goal, goal.ours());
        Timing peer = timing(goal, goal.peer());
        double ratio = peer.median() / ours.median();
        return String.format(
                Locale.ROOT,
                "%s | %s %s | %s %s | %.2f | %.2f | %s",
                goal.work(),
                goal.ours(),
                quartiles(ours),
                goal.peer(),
                quartiles(peer),
                ratio,
                goal.ratio(),
                ratio >= goal.ratio() ? "yes" : "no");
    }

    private Timing timing(Goal goal, String method) {
        Timing timing = timings.get(Timing.Key.of(goal.benchmark(), method, goal.parameters()));
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
