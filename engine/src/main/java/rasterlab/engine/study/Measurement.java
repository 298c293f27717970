package rasterlab.engine.study;

import java.util.List;

/**
 * One method on one workload: a point of the chart.
 *
 * @param workload its name; {@code size} is its place on the chart's axis
 * @param cost {@link Cost#NONE} where the method refused, crashed or did not end
 * @param error over all inputs of the workload: the worst distance, the sums of the counts, the
 *     first difference of the first input that has one
 * @param kind the worst verdict among the inputs
 * @param detail one line for people, as in {@link Verdict#detail}; may be empty
 * @param errors the worst distance for each input; none where it is not known
 */
public record Measurement(
        String method,
        String workload,
        int size,
        Cost cost,
        Deviation error,
        Verdict.Kind kind,
        String detail,
        List<Double> errors) {
    public Measurement {
        errors = List.copyOf(errors);
    }

    /** A measurement of which the errors of single inputs are not known. */
    public Measurement(
            String method,
            String workload,
            int size,
            Cost cost,
            Deviation error,
            Verdict.Kind kind,
            String detail) {
        this(method, workload, size, cost, error, kind, detail, List.of());
    }

    /** Whether the method answered all inputs, well or badly, and so has an error. */
    public boolean isAnswered() {
        return kind.compareTo(Verdict.Kind.REFUSED) < 0;
    }

    /** This measurement at another cost. */
    public Measurement with(Cost other) {
        return new Measurement(method, workload, size, other, error, kind, detail, errors);
    }
}
