package rasterlab.engine.study;

import java.util.List;

/**
 * The inputs that a study measures as one point of a chart: several of one size.
 *
 * @param name lower-case with hyphens
 * @param size the size that the chart's axis shows, in the topic's items per input; at least 1
 * @param inputs at least one
 * @param <I> one input of the topic
 */
public record Workload<I>(String name, int size, List<I> inputs) {
    public Workload {
        inputs = List.copyOf(inputs);
        if (size < 1)
            throw new IllegalArgumentException(
                    "workload '" + name + "' needs a size of at least 1, got " + size);
        if (inputs.isEmpty())
            throw new IllegalArgumentException("workload '" + name + "' needs at least one input");
    }
}
