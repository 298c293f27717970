package rasterlab.app.mine;

import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * A topic in which the user's own method is found by its name; all else is the topic's.
 *
 * @param methods that it lists
 */
record OwnTopic<C, I, O>(Topic<C, I, O> topic, OwnMethods own, List<Method<C>> methods)
        implements Topic<C, I, O> {
    @Override
    public Method<C> method(String name) {
        return own.method(topic, name);
    }

    @Override
    public String name() {
        return topic.name();
    }

    @Override
    public String lab() {
        return topic.lab();
    }

    @Override
    public Class<C> contract() {
        return topic.contract();
    }

    @Override
    public List<Hazard<I>> hazards() {
        return topic.hazards();
    }

    @Override
    public List<Workload<I>> workloads() {
        return topic.workloads();
    }

    @Override
    public List<Mutant<C>> mutants() {
        return topic.mutants();
    }

    @Override
    public List<Mutant<C>> mutants(String method) {
        return topic.mutants(method);
    }

    @Override
    public O record(C method, I input, int limit) {
        return topic.record(method, input, limit);
    }

    @Override
    public O run(C method, I input, int limit) {
        return topic.run(method, input, limit);
    }

    @Override
    public O recordPart(C method, I input, int limit) {
        return topic.recordPart(method, input, limit);
    }

    @Override
    public long spend(C method, I input) {
        return topic.spend(method, input);
    }

    @Override
    public O exact(I input, int limit) {
        return topic.exact(input, limit);
    }

    @Override
    public O exactPart(I input, int limit) {
        return topic.exactPart(input, limit);
    }

    @Override
    public Deviation compare(I input, O exact, O actual) {
        return topic.compare(input, exact, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return topic.correct(deviation);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return topic.usable(deviation);
    }

    @Override
    public Map<String, Long> operations(C method, I input) {
        return topic.operations(method, input);
    }

    @Override
    public int mostItems() {
        return topic.mostItems();
    }

    @Override
    public Map<String, String> vocabulary() {
        return topic.vocabulary();
    }

    @Override
    public Format<C, I, O> format() {
        return topic.format();
    }

    @Override
    public String item() {
        return topic.item();
    }

    @Override
    public String errorUnit() {
        return topic.errorUnit();
    }

    @Override
    public long mostBeforeEndless(long exactItems) {
        return topic.mostBeforeEndless(exactItems);
    }
}
