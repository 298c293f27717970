package rasterlab.engine.study;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import rasterlab.engine.study.measuring.PaceComparison.Order;

/**
 * The methods of one workload of which none is told to be both faster and as accurate as another.
 *
 * <p>A method beats another that is told to be slower and has no smaller error, or that is told to
 * be alike and has a larger one; where times are not told apart, nothing is beaten. Errors up to
 * the topic's stated bound are equal: all of them count as exact.
 *
 * @param ranking of the workload
 * @param beatenBy each method that is beaten, to those that beat it, the quickest first
 */
public record ParetoFront(Ranking ranking, Map<String, List<String>> beatenBy) {
    /** The front of one workload. */
    public static ParetoFront of(Study study, String workload) {
        Ranking ranking = Ranking.of(study, workload);
        Map<String, List<String>> beatenBy = new LinkedHashMap<>();
        for (int place = 0; place < ranking.places().size(); place++) {
            List<String> by = beatersOf(ranking, place);
            if (!by.isEmpty()) beatenBy.put(ranking.places().get(place).method(), by);
        }
        return new ParetoFront(ranking, beatenBy);
    }

    private static List<String> beatersOf(Ranking ranking, int place) {
        double error = error(ranking.places().get(place));
        return IntStream.range(0, ranking.places().size())
                .filter(other -> other != place)
                .filter(
                        other -> {
                            double others = error(ranking.places().get(other));
                            if (others > error) return false;
                            Order order = ranking.compared(other, place).order();
                            return order == Order.FASTER || order == Order.ALIKE && others < error;
                        })
                .mapToObj(other -> ranking.places().get(other).method())
                .toList();
    }

    /**
     * The error that a method is judged by: 0 where it counts as exact, endless where its items are
     * not the right ones though each is where it should be.
     */
    public static double error(Measurement measured) {
        if (measured.kind() == Verdict.Kind.EXACT) return 0;
        double worst = measured.error().worst();
        return worst == 0 ? Double.POSITIVE_INFINITY : worst;
    }

    public boolean isBeaten(String method) {
        return beatenBy.containsKey(method);
    }

    /** The methods that nothing beats, the quickest first. */
    public List<Measurement> front() {
        return ranking.places().stream().filter(one -> !isBeaten(one.method())).toList();
    }

    /** The corners of the front: those that have a smaller error than every quicker one. */
    public List<Measurement> corners() {
        var corners = new ArrayList<Measurement>();
        double least = Double.POSITIVE_INFINITY;
        for (Measurement one : front()) {
            if (!corners.isEmpty() && error(one) >= least) continue;
            least = error(one);
            corners.add(one);
        }
        return corners;
    }

    /**
     * The workload whose methods differ most in their errors, the largest of those: where accuracy
     * has a price, if anywhere.
     */
    public static String telling(Study study) {
        return Ranking.all(study).stream()
                .filter(one -> !one.places().isEmpty())
                .max(
                        Comparator.comparingLong(ParetoFront::errors)
                                .thenComparingInt(one -> one.places().get(0).size()))
                .map(Ranking::workload)
                .orElseGet(() -> study.measurements().get(0).workload());
    }

    private static long errors(Ranking ranking) {
        return ranking.places().stream().mapToDouble(ParetoFront::error).distinct().count();
    }
}
