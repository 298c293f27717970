package rasterlab.engine.study;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.study.measuring.PaceComparison.Order;

/**
 * A range of sizes in which the same method is best: the quickest of those with the least error.
 *
 * <p>Another one takes over only where it has a smaller error or is told to be faster, so that
 * noise makes no regimes. Source: P. Panchekha and others, Automatically Improving Accuracy for
 * Floating Point Expressions, PLDI 2015, section 4.8.
 *
 * @param from least size measured in it
 * @param to greatest size measured in it
 */
public record Regime(String method, int from, int to) {
    /**
     * The regimes along those workloads, from one end to the other without a gap but for workloads
     * that no method was timed on.
     *
     * @param workloads their names, by size
     */
    public static List<Regime> along(Study study, List<String> workloads) {
        var regimes = new ArrayList<Regime>();
        for (String workload : workloads) {
            Ranking ranking = Ranking.of(study, workload);
            if (ranking.places().isEmpty()) continue;
            String before = regimes.isEmpty() ? "" : regimes.get(regimes.size() - 1).method();
            Measurement best = ranking.places().get(best(ranking, before));
            if (best.method().equals(before)) {
                Regime last = regimes.remove(regimes.size() - 1);
                regimes.add(new Regime(before, last.from(), best.size()));
            } else regimes.add(new Regime(best.method(), best.size(), best.size()));
        }
        return regimes;
    }

    private static int best(Ranking ranking, String before) {
        List<Measurement> places = ranking.places();
        double least = places.stream().mapToDouble(ParetoFront::error).min().orElseThrow();
        int quickest = 0;
        while (ParetoFront.error(places.get(quickest)) > least) quickest++;
        for (int place = quickest; place < places.size(); place++) {
            Measurement one = places.get(place);
            boolean stays = one.method().equals(before) && ParetoFront.error(one) == least;
            if (stays && ranking.compared(quickest, place).order() != Order.FASTER) return place;
        }
        return quickest;
    }
}
