package rasterlab.app.study;

import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.Topic;

/**
 * A study whose costs are what was counted, not what was timed: the same on every machine and at
 * any time. All operations count alike.
 */
public final class CountedStudy {
    private CountedStudy() {}

    /**
     * The study with operations per item for nanoseconds; a method that counts none has no cost.
     */
    public static Study of(Study study) {
        List<Measurement> counted =
                study.measurements().stream().map(one -> counted(study, one)).toList();
        return new Study(study.topic(), study.item(), study.errorUnit(), counted);
    }

    private static Measurement counted(Study study, Measurement one) {
        long items = one.cost().counts().getOrDefault("items", 0L);
        long operations =
                StudyCounts.of(study).names().stream()
                        .mapToLong(name -> one.cost().counts().getOrDefault(name, 0L))
                        .sum();
        boolean known = items > 0 && operations > 0;
        Map<String, Long> counts = one.cost().counts();
        Cost cost =
                known
                        ? Cost.of(List.of((double) operations / items), counts)
                        : new Cost(0, 0, 0, counts);
        return one.with(cost);
    }

    /** Whether a method of the topic counts anything. */
    public static <C, I, O> boolean isPossible(Topic<C, I, O> topic) {
        I input = topic.workloads().get(0).inputs().get(0);
        return topic.methods().stream()
                .anyMatch(method -> !topic.operations(method.implementation(), input).isEmpty());
    }
}
