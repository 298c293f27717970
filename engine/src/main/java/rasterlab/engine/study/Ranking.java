package rasterlab.engine.study;

import java.util.Comparator;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;
import rasterlab.engine.study.measuring.PaceComparison;

/**
 * The methods of one workload by their medians, the quickest first, and what may be said of them.
 *
 * @param workload its name
 * @param places those that were timed
 * @param noise how many times a fixed load's median was off beside them
 */
public record Ranking(String workload, List<Measurement> places, double noise) {
    public Ranking {
        places = List.copyOf(places);
    }

    /** The ranking of one workload. */
    public static Ranking of(Study study, String workload) {
        List<Measurement> places =
                study.measurements().stream()
                        .filter(one -> one.workload().equals(workload) && one.cost().timed())
                        .sorted(Comparator.comparingDouble(one -> one.cost().medianNanos()))
                        .toList();
        return new Ranking(workload, places, study.noise(workload));
    }

    /** The rankings of all workloads, in the study's order. */
    public static List<Ranking> all(Study study) {
        return study.measurements().stream()
                .map(Measurement::workload)
                .distinct()
                .map(workload -> of(study, workload))
                .toList();
    }

    /** How one place stands to another. */
    public PaceComparison compared(int place, int other) {
        return PaceComparison.of(
                places.get(place).cost().samples(), places.get(other).cost().samples(), noise);
    }

    /** How a place stands to the next. */
    public PaceComparison toNext(int place) {
        return compared(place, place + 1);
    }

    /** How many rounds the method with most of them has. */
    public int rounds() {
        return places.stream().mapToInt(one -> one.cost().rounds().size()).max().orElse(0);
    }

    /** Number of neighbours that are not told apart, nor alike. */
    public int open() {
        return (int)
                IntStream.range(1, places.size())
                        .filter(next -> !toNext(next - 1).order().isSettled())
                        .count();
    }

    /**
     * About how many further rounds would settle all neighbours that are open; empty where none is,
     * or where no reasonable number would settle one of them.
     */
    public OptionalInt more() {
        List<PaceComparison> open =
                IntStream.range(1, places.size())
                        .mapToObj(next -> toNext(next - 1))
                        .filter(one -> !one.order().isSettled())
                        .toList();
        boolean hopeless = open.stream().anyMatch(one -> one.more().isEmpty());
        return hopeless
                ? OptionalInt.empty()
                : open.stream().mapToInt(one -> one.more().getAsInt()).max();
    }
}
