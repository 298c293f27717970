package rasterlab.app.study;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.mine.OwnProgram;
import rasterlab.engine.study.Cost;
import rasterlab.engine.study.HazardTrial;
import rasterlab.engine.study.HazardTrial.VerdictCell;
import rasterlab.engine.study.Measurement;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Progress;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudyRunner;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.study.Topic;
import rasterlab.engine.study.Workload;

/**
 * A study with the user's own program. Its error is judged as every method's. Its cost is that of a
 * right method, measured with all others, times what the program takes longer than that method,
 * both timed in processes of their own: the way there and back is no cost of the program's.
 */
public final class OwnStudy<C, I, O> {
    private static final String REFERENCE = "reference";

    /**
     * A time longer than a program that hangs is waited for on a busy machine, before it is
     * stopped.
     */
    private static final Duration LONGEST = Duration.ofMinutes(2);

    private final Topic<C, I, O> topic;
    private final OwnProgram program;
    private final OwnMethods own;

    /**
     * @param topic with its own methods alone
     * @param program the topic's in {@code own}
     */
    public OwnStudy(Topic<C, I, O> topic, OwnProgram program, OwnMethods own) {
        this.topic = topic;
        this.program = program;
        this.own = own;
    }

    /**
     * Measures as {@link StudyRunner#measure} does. Where it is cancelled, the program has no row
     * on the workloads on which it was not measured to the end.
     */
    public Study measure(
            StudySettings settings, Consumer<Progress> progress, BooleanSupplier cancelled)
            throws InterruptedException {
        Optional<Object> reference = program.reference();
        Study all =
                StudyRunner.measure(
                        own.with(topic, reference.map(this::reference).stream().toList()),
                        settings,
                        progress,
                        cancelled);
        Study mine =
                StudyRunner.measure(
                        own.only(topic, List.of(own.method(topic, OwnMethods.NAME))),
                        new StudySettings(Duration.ZERO, Duration.ofNanos(1), 1, LONGEST),
                        done -> {},
                        cancelled);
        var measurements = new ArrayList<Measurement>();
        for (Workload<I> workload : topic.workloads()) {
            measurements.addAll(
                    all.measurements().stream()
                            .filter(one -> one.workload().equals(workload.name()))
                            .filter(one -> !one.method().equals(REFERENCE))
                            .toList());
            Optional<Measurement> judged = of(mine, workload, OwnMethods.NAME);
            if (judged.isPresent() && !cancelled.getAsBoolean())
                measurements.add(
                        withCost(
                                judged.get(),
                                workload,
                                of(all, workload, REFERENCE).map(Measurement::cost)));
        }
        return all.with(measurements);
    }

    /** The program's verdict on each hazard, as {@link HazardTrial#table}. */
    List<VerdictCell> hazards(Consumer<VerdictCell> judged, BooleanSupplier cancelled) {
        program.prepare();
        return HazardTrial.table(
                own.only(topic, List.of(own.method(topic, OwnMethods.NAME))),
                LONGEST,
                judged,
                cancelled);
    }

    @SuppressWarnings("unchecked") // the exercise's model implements the topic's contract
    private Method<C> reference(Object method) {
        return Method.right(REFERENCE, (C) method);
    }

    /** The measurement of a method on a workload; empty where the study was cancelled before. */
    private static Optional<Measurement> of(Study study, Workload<?> workload, String method) {
        return study.measurements().stream()
                .filter(one -> one.workload().equals(workload.name()))
                .filter(one -> one.method().equals(method))
                .findFirst();
    }

    private Measurement withCost(Measurement mine, Workload<I> workload, Optional<Cost> reference)
            throws InterruptedException {
        boolean answered = mine.cost().timed();
        OptionalDouble slowness =
                answered && reference.isPresent()
                        ? program.slowness(workload.inputs())
                        : OptionalDouble.empty();
        return mine.with(
                slowness.isPresent()
                        ? times(reference.get(), slowness.getAsDouble(), mine.cost())
                        : Cost.NONE);
    }

    private static Cost times(Cost reference, double factor, Cost mine) {
        return Cost.of(
                reference.rounds().stream().map(nanos -> factor * nanos).toList(), mine.counts());
    }
}
