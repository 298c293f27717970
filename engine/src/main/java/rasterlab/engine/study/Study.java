package rasterlab.engine.study;

import java.util.List;

/**
 * Methods of one topic on the same workloads, each with its cost and its error.
 *
 * @param topic the topic's name
 * @param item what the cost is per, in the singular
 * @param errorUnit unit of each measurement's {@link Deviation#worst}
 * @param measurements by workload, smallest first, and within one by method in the topic's order
 */
public record Study(String topic, String item, String errorUnit, List<Measurement> measurements) {
    public Study {
        measurements = List.copyOf(measurements);
    }
}
