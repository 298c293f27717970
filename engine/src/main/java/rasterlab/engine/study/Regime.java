package rasterlab.engine.study;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.engine.study.measuring.PaceComparison.Order;

/**
 * A range of sizes in which the same method is best: the quickest of those with the least error; or
 * in which it is open which of several is.
 *
 * <p>A method is best from where it is told to be faster than all others with the least error, and
 * stays so until another has a smaller error or is told to be faster, so that noise makes no
 * regimes. Source: P. Panchekha and others, Automatically Improving Accuracy for Floating Point
 * Expressions, PLDI 2015, section 4.8.
 *
 * @param methods the best one; several where these are not told apart in the whole range
 * @param from least size measured in it
 * @param to greatest size measured in it
 */
public record Regime(List<String> methods, int from, int to) {
    public Regime {
        methods = List.copyOf(methods);
    }

    /** Whether it is open which of several methods is best. */
    public boolean isOpen() {
        return methods.size() > 1;
    }

    /**
     * The regimes along those workloads, from one end to the other without a gap but for workloads
     * that no method was timed on.
     *
     * @param workloads their names, by size
     */
    public static List<Regime> along(Study study, List<String> workloads) {
        var regimes = new ArrayList<Regime>();
        List<String> accurateBefore = List.of();
        for (String workload : workloads) {
            Ranking ranking = Ranking.of(study, workload);
            if (ranking.places().isEmpty()) continue;
            int size = ranking.places().get(0).size();
            List<Integer> accurate = accurate(ranking);
            List<String> best = best(ranking, accurate);
            List<String> names = names(ranking, accurate).stream().sorted().toList();
            Regime next = new Regime(best, size, size);
            if (!regimes.isEmpty()) {
                Regime last = regimes.get(regimes.size() - 1);
                List<String> stay = last.methods().stream().filter(best::contains).toList();
                boolean stays =
                        last.isOpen()
                                ? stay.size() > 1 && names.equals(accurateBefore)
                                : !stay.isEmpty();
                if (stays) {
                    regimes.remove(last);
                    next = new Regime(stay, last.from(), size);
                }
            }
            regimes.add(next);
            accurateBefore = names;
        }
        return regimes;
    }

    /** The places of the methods with the least error, the quickest first. */
    private static List<Integer> accurate(Ranking ranking) {
        List<Measurement> places = ranking.places();
        double least = places.stream().mapToDouble(ParetoFront::error).min().orElseThrow();
        return IntStream.range(0, places.size())
                .filter(place -> ParetoFront.error(places.get(place)) == least)
                .boxed()
                .toList();
    }

    /** The methods that the quickest one is not told to be faster than, itself among them. */
    private static List<String> best(Ranking ranking, List<Integer> accurate) {
        int quickest = accurate.get(0);
        return names(
                ranking,
                accurate.stream()
                        .filter(
                                place ->
                                        place == quickest
                                                || ranking.compared(quickest, place).order()
                                                        != Order.FASTER)
                        .toList());
    }

    private static List<String> names(Ranking ranking, List<Integer> places) {
        return places.stream().map(place -> ranking.places().get(place).method()).toList();
    }
}
