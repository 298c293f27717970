package rasterlab.engine.study;

import java.lang.management.ManagementFactory;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CancellationException;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rasterlab.engine.study.measuring.Calibration;
import rasterlab.engine.study.measuring.Machine;

/**
 * Measures every method of a topic on every workload.
 *
 * <p>On each workload a method is first judged, input by input, and only one that answers all of
 * them is timed. All are warmed up before any is timed, and their rounds take turns, so that the
 * compiler's work and a busy moment of the machine hit all alike.
 */
public final class StudyRunner<C, I, O> {
    private final Topic<C, I, O> topic;
    private final StudySettings settings;
    private final BiConsumer<Progress, Supplier<Study>> progress;
    private final BooleanSupplier cancelled;
    private final Calibration calibration = new Calibration();
    private final Instant begun = Instant.now();
    private final double loadBefore = loadOfTheMachine();
    private final List<WorkloadTrial<C, I, O>> loads = new ArrayList<>();
    private final int total;
    private int done;
    private boolean whole;

    private StudyRunner(
            Topic<C, I, O> topic,
            StudySettings settings,
            BiConsumer<Progress, Supplier<Study>> progress,
            BooleanSupplier cancelled) {
        this.topic = topic;
        this.settings = settings;
        this.progress = progress;
        this.cancelled = cancelled;
        total = topic.workloads().size() * topic.methods().size() * (settings.rounds() + 2);
    }

    /**
     * The study of one topic.
     *
     * @param progress told after each piece of work, on the caller's thread
     * @param cancelled asked before each piece of work; then the study is what was measured so far
     */
    public static <C, I, O> Study measure(
            Topic<C, I, O> topic,
            StudySettings settings,
            Consumer<Progress> progress,
            BooleanSupplier cancelled) {
        return follow(topic, settings, (step, soFar) -> progress.accept(step), cancelled);
    }

    /**
     * The study of one topic.
     *
     * @param progress told after each piece of work, on the caller's thread, and what the study is
     *     by then, should it be asked for at once
     * @param cancelled asked before each piece of work; then the study is what was measured so far
     */
    public static <C, I, O> Study follow(
            Topic<C, I, O> topic,
            StudySettings settings,
            BiConsumer<Progress, Supplier<Study>> progress,
            BooleanSupplier cancelled) {
        return new StudyRunner<>(topic, settings, progress, cancelled).run();
    }

    private Study run() {
        try {
            for (Workload<I> workload : topic.workloads())
                loads.add(new WorkloadTrial<>(topic, workload, settings));
            for (var load : loads) for (var trial : load.trials()) step(trial, trial::judge);
            warmUp();
            for (var load : loads) load.begin(settings.plan());
            while (round()) continue;
            whole = true;
        } catch (CancellationException stopped) {
            whole = false;
        }
        return study();
    }

    /** Runs all in turns: a method that is warm alone may be slow again once others have run. */
    private void warmUp() {
        boolean first = true;
        for (boolean more = true; more; first = false) {
            more = false;
            for (var load : loads)
                for (var trial : load.trials()) {
                    requireGoing();
                    if (!trial.isWarm()) trial.warmUp();
                    more |= !trial.isWarm();
                    if (first) tell(trial);
                }
        }
    }

    /** Makes one more round of each workload that needs one; whether any did. */
    private boolean round() {
        boolean any = false;
        for (var load : loads) {
            if (!load.rounds().more()) continue;
            any = true;
            List<Integer> order = load.rounds().order();
            load.rounds().addFixed(calibration.sample(settings.round()));
            for (int number : order) step(load.trials().get(number), () -> load.round(number));
        }
        return any;
    }

    private void step(MethodTrial<C, I, O> trial, Runnable work) {
        requireGoing();
        work.run();
        tell(trial);
    }

    private void requireGoing() {
        if (cancelled.getAsBoolean())
            throw new CancellationException("study of '" + topic.name() + "' was cancelled");
    }

    private void tell(MethodTrial<C, I, O> trial) {
        done = Math.min(total, done + 1);
        progress.accept(new Progress(done, total, trial.method(), trial.workload()), this::study);
    }

    private Study study() {
        var measurements = new ArrayList<Measurement>();
        Map<String, List<Double>> fixed = new TreeMap<>();
        for (var load : loads) {
            measurements.addAll(load.measurements());
            fixed.put(load.name(), load.rounds().fixed().all());
        }
        var how =
                new StudyConditions(
                        settings,
                        begun,
                        Machine.here(),
                        loadBefore,
                        loadOfTheMachine(),
                        fixed,
                        whole);
        return new Study(
                topic.name(), topic.item(), topic.errorUnit(), measurements, Optional.of(how));
    }

    private static double loadOfTheMachine() {
        return ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage();
    }
}
