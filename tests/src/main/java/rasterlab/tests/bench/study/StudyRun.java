package rasterlab.tests.bench.study;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Result of one run of {@code ./lab study}.
 *
 * @param told the pairs that it tells apart
 * @param pairs number of all pairs
 * @param medians nanoseconds per item by workload and method
 */
record StudyRun(Set<Faster> told, int pairs, Map<String, Double> medians) {
    /** The largest share that two medians of the same load may differ by. */
    static final double NEAR = 0.15;

    /** A pair of which the first method is faster at that workload. */
    record Faster(String workload, String method, String other) {
        Faster reversed() {
            return new Faster(workload, other, method);
        }
    }

    StudyRun {
        told = Set.copyOf(told);
        medians = Map.copyOf(medians);
    }

    /** The run that wrote that JSON. */
    static StudyRun of(JsonNode json) {
        var told = new LinkedHashSet<Faster>();
        for (JsonNode pair : json.required("comparisons")) {
            var faster =
                    new Faster(
                            pair.required("workload").asText(),
                            pair.required("method").asText(),
                            pair.required("other").asText());
            String order = pair.required("order").asText();
            if (order.equals("faster")) told.add(faster);
            if (order.equals("slower")) told.add(faster.reversed());
        }
        var medians = new TreeMap<String, Double>();
        for (JsonNode one : json.required("measurements"))
            if (one.required("nanosPerItem").isObject())
                medians.put(
                        one.required("workload").asText() + " " + one.required("method").asText(),
                        one.required("nanosPerItem").required("median").asDouble());
        return new StudyRun(told, json.required("comparisons").size(), medians);
    }

    /** How many pairs both tell apart, in whatever order. */
    long bothTold(StudyRun other) {
        return told.stream()
                .filter(one -> other.told.contains(one) || other.told.contains(one.reversed()))
                .count();
    }

    /** How many pairs the other puts in the opposite order. */
    long opposed(StudyRun other) {
        return told.stream().filter(one -> other.told.contains(one.reversed())).count();
    }

    /** Kendall's τ over the pairs that both tell apart; 1 where there is none. */
    double tau(StudyRun other) {
        long both = bothTold(other);
        return both == 0 ? 1 : 1 - 2.0 * opposed(other) / both;
    }

    /** The share of medians that differ by at most {@link #NEAR}. */
    double near(StudyRun other) {
        return medians.entrySet().stream()
                .filter(one -> other.medians.containsKey(one.getKey()))
                .mapToDouble(one -> one.getValue() / other.medians.get(one.getKey()))
                .mapToInt(ratio -> Math.max(ratio, 1 / ratio) <= 1 + NEAR ? 1 : 0)
                .average()
                .orElse(0);
    }
}
