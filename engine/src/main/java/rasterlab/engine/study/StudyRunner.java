package rasterlab.engine.study;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

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
    private final Consumer<Progress> progress;
    private final BooleanSupplier cancelled;
    private final int total;
    private int done;

    private StudyRunner(
            Topic<C, I, O> topic,
            StudySettings settings,
            Consumer<Progress> progress,
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
     * @param cancelled asked before each piece of work
     * @throws CancellationException when {@code cancelled} says so or the thread is interrupted
     */
    public static <C, I, O> Study measure(
            Topic<C, I, O> topic,
            StudySettings settings,
            Consumer<Progress> progress,
            BooleanSupplier cancelled) {
        return new StudyRunner<>(topic, settings, progress, cancelled).run();
    }

    private Study run() {
        var trials = new ArrayList<MethodTrial<C, I, O>>();
        for (Workload<I> workload : topic.workloads()) trials.addAll(trials(workload));
        for (var trial : trials) step(trial, trial::judge);
        for (var trial : trials) step(trial, trial::warmUp);
        for (int round = 0; round < settings.rounds(); round++)
            for (var trial : trials) step(trial, trial::round);
        List<Measurement> measurements = trials.stream().map(MethodTrial::measurement).toList();
        return new Study(topic.name(), topic.item(), topic.errorUnit(), measurements);
    }

    private List<MethodTrial<C, I, O>> trials(Workload<I> workload) {
        List<ExactAnswer<O>> answers =
                workload.inputs().stream().map(input -> ExactAnswer.to(topic, input)).toList();
        return topic.methods().stream()
                .map(method -> new MethodTrial<>(topic, method, workload, answers, settings))
                .toList();
    }

    private void step(MethodTrial<C, I, O> trial, Runnable work) {
        if (cancelled.getAsBoolean())
            throw new CancellationException("study of '" + topic.name() + "' was cancelled");
        work.run();
        done++;
        progress.accept(new Progress(done, total, trial.method(), trial.workload()));
    }
}
