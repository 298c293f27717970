package rasterlab.app.study;

import java.util.HashMap;
import java.util.List;
import java.util.function.Predicate;
import rasterlab.engine.Topics;
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
     * The study with operations for nanoseconds, per what the topic says; a method that counts none
     * has no cost.
     */
    public static Study of(Study study) {
        Topic<?, ?, ?> topic = Topics.named(study.topic());
        return counted(study, topic, topic::isWork);
    }

    /**
     * The study with the parts that answers are made of for nanoseconds, per what the topic says; a
     * method that does not say of how many has no cost.
     */
    public static Study ofParts(Study study) {
        Topic<?, ?, ?> topic = Topics.named(study.topic());
        return counted(study, topic, count -> topic.parts().filter(count::equals).isPresent());
    }

    private static Study counted(Study study, Topic<?, ?, ?> topic, Predicate<String> wanted) {
        List<String> names = StudyCounts.of(study).names().stream().filter(wanted).toList();
        boolean perItem = topic.countedPer().equals(topic.item());
        return new Study(
                study.topic(),
                topic.countedPer(),
                study.errorUnit(),
                study.measurements().stream().map(one -> counted(one, names, perItem)).toList());
    }

    private static Measurement counted(Measurement one, List<String> names, boolean perItem) {
        var counts = new HashMap<>(one.cost().counts());
        if (!perItem)
            counts.computeIfPresent(
                    StudyCounts.ITEMS,
                    (name, items) -> counts.getOrDefault(StudyCounts.INPUTS, items));
        long per = counts.getOrDefault(StudyCounts.ITEMS, 0L);
        long operations = names.stream().mapToLong(name -> counts.getOrDefault(name, 0L)).sum();
        boolean known = per > 0 && operations > 0;
        Cost cost =
                known
                        ? Cost.of(List.of((double) operations / per), counts)
                        : new Cost(0, 0, 0, counts);
        return one.with(cost);
    }

    /** Whether a method of the topic counts any work. */
    public static <C, I, O> boolean isPossible(Topic<C, I, O> topic) {
        I input = topic.workloads().get(0).inputs().get(0);
        return topic.methods().stream()
                .anyMatch(
                        method ->
                                topic.operations(method.implementation(), input).keySet().stream()
                                        .anyMatch(topic::isWork));
    }
}
