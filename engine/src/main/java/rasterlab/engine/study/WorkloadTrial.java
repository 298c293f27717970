package rasterlab.engine.study;

import java.util.List;
import rasterlab.engine.study.measuring.RoundPlan;
import rasterlab.engine.study.measuring.Rounds;

/** Every method on one workload while a study runs. */
final class WorkloadTrial<C, I, O> {
    private final Workload<I> workload;
    private final List<MethodTrial<C, I, O>> trials;
    private Rounds rounds = new Rounds(0, StudySettings.shortest().plan(), System::nanoTime);

    WorkloadTrial(Topic<C, I, O> topic, Workload<I> workload, StudySettings settings) {
        this.workload = workload;
        List<ExactAnswer<O>> answers =
                workload.inputs().stream().map(input -> ExactAnswer.to(topic, input)).toList();
        trials =
                topic.methods().stream()
                        .map(
                                method ->
                                        new MethodTrial<>(
                                                topic, method, workload, answers, settings))
                        .toList();
    }

    String name() {
        return workload.name();
    }

    List<MethodTrial<C, I, O>> trials() {
        return trials;
    }

    /** Begins with the rounds; the time for them runs from now on. */
    void begin(RoundPlan plan) {
        rounds = new Rounds(trials.size(), plan, System::nanoTime);
    }

    Rounds rounds() {
        return rounds;
    }

    /** Times a method once more. */
    void round(int number) {
        trials.get(number)
                .round()
                .ifPresentOrElse(nanos -> rounds.add(number, nanos), () -> rounds.lose(number));
    }

    /** The measurements of the methods that were judged. */
    List<Measurement> measurements() {
        return trials.stream().filter(MethodTrial::isJudged).map(MethodTrial::measurement).toList();
    }
}
