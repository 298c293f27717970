package rasterlab.engine.study;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import rasterlab.engine.study.measuring.Samples;
import rasterlab.engine.study.measuring.Stability;

/** One method on one workload while a study runs: judged once, then timed in rounds. */
final class MethodTrial<C, I, O> {
    private final Topic<C, I, O> topic;
    private final Method<C> method;
    private final Workload<I> workload;
    private final StudySettings settings;
    private final List<ExactAnswer<O>> answers;
    private final Samples nanosPerItem = new Samples();
    private final Stability stability = new Stability();
    private Duration warmed = Duration.ZERO;
    private final List<Double> errors = new ArrayList<>();
    private boolean judged;
    private final Map<String, Long> operations = new TreeMap<>();
    private Duration judging = Duration.ZERO;
    private long itemsPerPass;
    private Deviation error = Deviation.NONE;
    private Verdict worst = new Verdict(Verdict.Kind.EXACT, Deviation.NONE, "");

    /**
     * @param answers the exact answer to each input of the workload, in its order
     */
    MethodTrial(
            Topic<C, I, O> topic,
            Method<C> method,
            Workload<I> workload,
            List<ExactAnswer<O>> answers,
            StudySettings settings) {
        this.topic = topic;
        this.method = method;
        this.workload = workload;
        this.answers = answers;
        this.settings = settings;
    }

    /** The number of parts of the least warm-up. */
    private static final int WARM_UPS = 3;

    private record Sample(long nanos, long items, long passes) {
        double nanosPerItem() {
            return Math.max(1, nanos) / (double) items;
        }
    }

    String method() {
        return method.name();
    }

    String workload() {
        return workload.name();
    }

    /** Judges input by input, until one gets no answer. */
    void judge() {
        long start = System.nanoTime();
        for (int i = 0; i < answers.size() && answered(); i++)
            take(
                    HazardTrial.judge(
                            topic,
                            method,
                            workload.inputs().get(i),
                            answers.get(i),
                            settings.wallLimit()));
        judging = Duration.ofNanos(System.nanoTime() - start);
        if (answered()) count();
        judged = true;
    }

    /** Whether it was judged to the end. */
    boolean isJudged() {
        return judged;
    }

    /** Counts what the method does, under guard as everything it does. */
    private void count() {
        var outcome =
                Guard.call(
                        "counting of " + method.name(),
                        () -> {
                            var sums = new TreeMap<String, Long>();
                            for (I input : workload.inputs())
                                topic.operations(method.implementation(), Inputs.copy(input))
                                        .forEach((name, more) -> sums.merge(name, more, Long::sum));
                            return sums;
                        },
                        settings.wallLimit().plus(judging.multipliedBy(4)));
        if (outcome instanceof Guard.Returned<TreeMap<String, Long>> returned)
            operations.putAll(returned.value());
        else take(Verdicts.ofFailure(outcome));
    }

    /** Whether it has run long enough, and become no faster of late, or cannot be run. */
    boolean isWarm() {
        if (!answered()) return true;
        if (settings.warmUp().isZero()) return !warmed.isZero();
        if (warmed.compareTo(settings.warmUp()) < 0) return false;
        Duration longest = settings.warmUp().multipliedBy(StudySettings.LONGEST_WARM_UP);
        return stability.isReached() || warmed.compareTo(longest) >= 0;
    }

    /** Runs for a part of the time of its warm-up. */
    void warmUp() {
        Sample sample = run(settings.warmUp().dividedBy(WARM_UPS));
        warmed = warmed.plusNanos(Math.max(1, sample.nanos()));
        if (sample.items() > 0) stability.add(sample.nanosPerItem());
    }

    /** Times it per item in one more round; none where it has no time any longer. */
    OptionalDouble round() {
        Sample sample = run(settings.round());
        if (sample.items() == 0) return OptionalDouble.empty();
        nanosPerItem.add(sample.nanosPerItem());
        return OptionalDouble.of(sample.nanosPerItem());
    }

    Measurement measurement() {
        return new Measurement(
                method.name(),
                workload.name(),
                workload.size(),
                answered() ? cost() : Cost.NONE,
                answered() ? error : Deviation.NONE,
                worst.kind(),
                worst.detail(),
                answered() ? errors : List.of());
    }

    private void take(Verdict verdict) {
        if (verdict.kind().compareTo(worst.kind()) > 0) worst = verdict;
        Deviation more = verdict.deviation();
        if (!judged) errors.add(more.worst());
        error =
                new Deviation(
                        Math.max(error.worst(), more.worst()),
                        error.missing() + more.missing(),
                        error.extra() + more.extra(),
                        error.of() + more.of(),
                        error.first().isEmpty() ? more.first() : error.first());
    }

    private boolean answered() {
        return worst.kind().compareTo(Verdict.Kind.REFUSED) < 0;
    }

    private Sample run(Duration atLeast) {
        if (!answered()) return new Sample(0, 0, 0);
        // A pass takes about as long as judging did, so this is ample for the last one.
        Duration limit = atLeast.plus(settings.wallLimit()).plus(judging.multipliedBy(4));
        List<I> inputs = Inputs.copy(workload.inputs());
        var outcome =
                Guard.call(
                        "timing of " + method.name(),
                        () -> passes(inputs, atLeast.toNanos()),
                        limit);
        if (outcome instanceof Guard.Returned<Sample> returned) {
            itemsPerPass = returned.value().items() / returned.value().passes();
            return returned.value();
        }
        take(Verdicts.ofFailure(outcome));
        return new Sample(0, 0, 0);
    }

    /** Times nothing but the method's work: inputs are copied before the clock starts. */
    private Sample passes(List<I> inputs, long atLeastNanos) {
        C implementation = method.implementation();
        long items = 0;
        long passes = 0;
        long start = System.nanoTime();
        long elapsed;
        do {
            for (int i = 0; i < inputs.size(); i++)
                items += topic.spend(implementation, inputs.get(i));
            passes++;
            elapsed = System.nanoTime() - start;
        } while (elapsed < atLeastNanos);
        Inputs.requireUnchanged(inputs, workload.inputs());
        return new Sample(elapsed, items, passes);
    }

    private Cost cost() {
        var counts = new TreeMap<>(operations);
        counts.put("inputs", (long) workload.inputs().size());
        counts.put("items", itemsPerPass);
        return Cost.of(nanosPerItem.all(), counts);
    }
}
