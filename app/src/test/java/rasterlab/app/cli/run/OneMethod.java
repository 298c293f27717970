package rasterlab.app.cli.run;

import java.util.List;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Format;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * A topic of one method, {@code broken}, whose recorded answer is always the same.
 *
 * @param answer what {@link #record} returns
 */
record OneMethod<C, I, O>(C implementation, O answer) implements Topic<C, I, O> {
    @Override
    public String name() {
        return "topic";
    }

    /** The runner does not ask for it. */
    @Override
    public String lab() {
        throw new UnsupportedOperationException();
    }

    /** The runner does not ask for it. */
    @Override
    public Class<C> contract() {
        throw new UnsupportedOperationException();
    }

    /** A test gives the runner a format of its choice. */
    @Override
    public Format<C, I, O> format() {
        throw new UnsupportedOperationException();
    }

    @Override
    public List<Method<C>> methods() {
        return List.of(Method.failing("broken", implementation));
    }

    @Override
    public List<Hazard<I>> hazards() {
        return List.of();
    }

    @Override
    public List<Workload<I>> workloads() {
        return List.of();
    }

    @Override
    public O run(C method, I input, int limit) {
        return answer;
    }

    @Override
    public long spend(C method, I input) {
        return 0;
    }

    @Override
    public O exact(I input, int limit) {
        return answer;
    }

    @Override
    public Deviation compare(I input, O exact, O actual) {
        return Deviation.NONE;
    }

    @Override
    public String item() {
        return "item";
    }

    @Override
    public String errorUnit() {
        return "units";
    }
}
