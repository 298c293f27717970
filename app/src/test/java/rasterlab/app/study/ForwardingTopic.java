package rasterlab.app.study;

import java.util.List;
import java.util.Map;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/** A topic that answers as another does, but for what a test overrides. */
public abstract class ForwardingTopic<C, I, O> implements Topic<C, I, O> {
    private final Topic<C, I, O> whole;

    protected ForwardingTopic(Topic<C, I, O> whole) {
        this.whole = whole;
    }

    @Override
    public String name() {
        return whole.name();
    }

    @Override
    public String lab() {
        return whole.lab();
    }

    @Override
    public Class<C> contract() {
        return whole.contract();
    }

    @Override
    public Format<C, I, O> format() {
        return whole.format();
    }

    @Override
    public List<Method<C>> methods() {
        return whole.methods();
    }

    @Override
    public List<Hazard<I>> hazards() {
        return whole.hazards();
    }

    @Override
    public List<Workload<I>> workloads() {
        return whole.workloads();
    }

    @Override
    public O run(C method, I input, int limit) {
        return whole.record(method, input, limit);
    }

    @Override
    public long spend(C method, I input) {
        return whole.spend(method, input);
    }

    @Override
    public O exact(I input, int limit) {
        return whole.exact(input, limit);
    }

    @Override
    public Deviation compare(I input, O exact, O actual) {
        return whole.compare(input, exact, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return whole.correct(deviation);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return whole.usable(deviation);
    }

    @Override
    public Map<String, Long> operations(C method, I input) {
        return whole.operations(method, input);
    }

    @Override
    public int mostItems() {
        return whole.mostItems();
    }

    @Override
    public Map<String, String> vocabulary() {
        return whole.vocabulary();
    }

    @Override
    public String item() {
        return whole.item();
    }

    @Override
    public String errorUnit() {
        return whole.errorUnit();
    }

    @Override
    public long mostBeforeEndless(long exactItems) {
        return whole.mostBeforeEndless(exactItems);
    }
}
