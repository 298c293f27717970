package rasterlab.engine.study;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.predicate.PointQuestion;

/**
 * A topic that answers as another one does, but for what a subclass overrides.
 *
 * <p>{@link #record}, {@link #allMutants} and {@link #method} are not passed on: they are made of
 * what is, and so of what a subclass overrides.
 */
public abstract class ForwardingTopic<C, I, O> implements Topic<C, I, O> {
    private final Topic<C, I, O> other;

    protected ForwardingTopic(Topic<C, I, O> other) {
        this.other = other;
    }

    @Override
    public String name() {
        return other.name();
    }

    @Override
    public String lab() {
        return other.lab();
    }

    @Override
    public Class<C> contract() {
        return other.contract();
    }

    @Override
    public List<Method<C>> methods() {
        return other.methods();
    }

    @Override
    public List<Hazard<I>> hazards() {
        return other.hazards();
    }

    @Override
    public List<Workload<I>> workloads() {
        return other.workloads();
    }

    @Override
    public List<Mutant<C>> mutants() {
        return other.mutants();
    }

    @Override
    public List<Mutant<C>> mutants(String method) {
        return other.mutants(method);
    }

    @Override
    public List<Slip<C>> slips(C right) {
        return other.slips(right);
    }

    @Override
    public O run(C method, I input, int limit) {
        return other.run(method, input, limit);
    }

    @Override
    public O recordPart(C method, I input, int limit) {
        return other.recordPart(method, input, limit);
    }

    @Override
    public long spend(C method, I input) {
        return other.spend(method, input);
    }

    @Override
    public O exact(I input, int limit) {
        return other.exact(input, limit);
    }

    @Override
    public O exactPart(I input, int limit) {
        return other.exactPart(input, limit);
    }

    @Override
    public Deviation compare(I input, O exact, O actual) {
        return other.compare(input, exact, actual);
    }

    @Override
    public boolean correct(Deviation deviation) {
        return other.correct(deviation);
    }

    @Override
    public boolean usable(Deviation deviation) {
        return other.usable(deviation);
    }

    @Override
    public Map<String, Long> operations(C method, I input) {
        return other.operations(method, input);
    }

    @Override
    public boolean isWork(String count) {
        return other.isWork(count);
    }

    @Override
    public String countedPer() {
        return other.countedPer();
    }

    @Override
    public Optional<String> parts() {
        return other.parts();
    }

    @Override
    public int mostItems() {
        return other.mostItems();
    }

    @Override
    public boolean isPromised(I input) {
        return other.isPromised(input);
    }

    @Override
    public Optional<PointQuestion<I, O>> question() {
        return other.question();
    }

    @Override
    public Map<String, String> vocabulary() {
        return other.vocabulary();
    }

    @Override
    public Format<C, I, O> format() {
        return other.format();
    }

    @Override
    public String item() {
        return other.item();
    }

    @Override
    public boolean sized() {
        return other.sized();
    }

    @Override
    public String errorUnit() {
        return other.errorUnit();
    }

    @Override
    public long mostBeforeEndless(long exactItems) {
        return other.mostBeforeEndless(exactItems);
    }
}
