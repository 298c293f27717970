package rasterlab.tests.bench.grader;

import java.time.Instant;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Tells from when results came how fairly students took turns. */
final class FairOrder {
    private FairOrder() {}

    /** A result, and the moment at which its student could read it. */
    record TimedResult(String student, Instant at) {}

    /**
     * The most results that a student had more than another who still waited for one: 1 where they
     * take turns.
     */
    static int lead(List<TimedResult> results) {
        Map<String, Integer> waiting = new HashMap<>();
        for (TimedResult one : results) waiting.merge(one.student(), 1, Integer::sum);
        Map<String, Integer> had = new HashMap<>();
        int lead = 0;
        for (TimedResult one :
                results.stream().sorted(Comparator.comparing(TimedResult::at)).toList()) {
            int mine = had.merge(one.student(), 1, Integer::sum);
            waiting.computeIfPresent(one.student(), (who, left) -> left == 1 ? null : left - 1);
            int least =
                    waiting.keySet().stream()
                            .filter(other -> !other.equals(one.student()))
                            .mapToInt(other -> had.getOrDefault(other, 0))
                            .min()
                            .orElse(mine);
            lead = Math.max(lead, mine - least);
        }
        return lead;
    }
}
