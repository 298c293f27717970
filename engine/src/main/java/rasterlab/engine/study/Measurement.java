package rasterlab.engine.study;

/**
 * One method on one workload: a point of the chart.
 *
 * @param workload its name; {@code size} is its place on the chart's axis
 * @param cost {@link Cost#NONE} where the method refused, crashed or did not end
 * @param error over all inputs of the workload: the worst distance, the sums of the counts, the
 *     first difference of the first input that has one
 * @param kind the worst verdict among the inputs
 * @param detail one line for people, as in {@link Verdict#detail}; may be empty
 */
public record Measurement(
        String method,
        String workload,
        int size,
        Cost cost,
        Deviation error,
        Verdict.Kind kind,
        String detail) {}
