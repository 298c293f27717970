package rasterlab.engine.study;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.study.measuring.Rounds;
import rasterlab.engine.study.measuring.Samples;

/**
 * Methods of one topic on the same workloads, each with its cost and its error.
 *
 * @param topic the topic's name
 * @param item what the cost is per, in the singular
 * @param errorUnit unit of each measurement's {@link Deviation#worst}
 * @param measurements by workload, smallest first, and within one by method in the topic's order
 * @param circumstances how it was measured; none for figures that were measured elsewhere
 */
public record Study(
        String topic,
        String item,
        String errorUnit,
        List<Measurement> measurements,
        Optional<StudyConditions> circumstances) {
    private static final double BUSY = 2;

    public Study {
        measurements = List.copyOf(measurements);
    }

    /** A study of figures that were measured elsewhere. */
    public Study(String topic, String item, String errorUnit, List<Measurement> measurements) {
        this(topic, item, errorUnit, measurements, Optional.empty());
    }

    /** This study with other measurements. */
    public Study with(List<Measurement> others) {
        return new Study(topic, item, errorUnit, others, circumstances);
    }

    /** How many times the median of a fixed load was off beside that workload, at least 1. */
    public double noise(String workload) {
        return circumstances
                .map(how -> how.fixed().getOrDefault(workload, List.of()))
                .map(fixed -> Rounds.noise(Samples.of(fixed)))
                .orElse(1.0);
    }

    /** The most of that beside any workload. */
    public double noise() {
        return circumstances.stream()
                .flatMap(how -> how.fixed().keySet().stream())
                .mapToDouble(this::noise)
                .max()
                .orElse(1);
    }

    /** Whether the machine was so busy that a share of the times would say little of its noise. */
    public boolean isBusy() {
        return noise() >= BUSY;
    }

    /** Whether a round of any method was timed; until then they are judged and warmed up. */
    public boolean isTimed() {
        return measurements.stream().anyMatch(one -> one.cost().timed());
    }

    /** Whether it came to its end. */
    public boolean isWhole() {
        return circumstances.map(StudyConditions::whole).orElse(true);
    }
}
