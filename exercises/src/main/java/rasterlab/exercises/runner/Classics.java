package rasterlab.exercises.runner;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.measuring.MedianInterval;
import rasterlab.engine.study.measuring.RoundPlan;
import rasterlab.engine.study.measuring.Rounds;
import rasterlab.engine.study.measuring.Samples;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.TopicGrading.TimingInputs;
import rasterlab.exercises.score.SpeedFigures;

/**
 * Times a topic's right methods against an exercise's reference, in this process, in turns and on
 * the inputs that a student was timed on last; and judges their errors on given calls.
 *
 * <p>Several threads may ask; they take turns, so that none disturbs another's times.
 */
final class Classics {
    /** Rounds in which each has a pass; where a round takes long, fewer are made. */
    private static final int ROUNDS = RoundPlan.LEAST;

    private static final int LEAST_ROUNDS = 2;

    private static final long SEED = 1;

    /** Passes before those that count, when an exercise is asked for first: Java compiles then. */
    private static final int FIRST_ROUNDS = 20;

    /** A pass ends with the input during which so much processor time has passed. */
    private static final long PASS_NANOS = 1_000_000;

    /** Wall time for all passes on a busy machine; an idle one needs about 50 ms. */
    private static final long BUDGET_NANOS = 1_000_000_000;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Map<String, Map<String, Double>> errors = new HashMap<>();
    private final Set<String> warm = new HashSet<>();

    /**
     * The methods that answer both calls and inputs.
     *
     * @param reference as the topic calls it
     * @param calls the same ones each time, of which at least one tells an error
     */
    synchronized List<SpeedFigures.MethodSpeed> classicsFor(
            Exercise exercise,
            TopicGrading topic,
            TimingInputs timing,
            Object reference,
            List<GradedCall> calls) {
        String key = exercise.id() + ' ' + exercise.revision();
        Map<String, Double> known = errors.computeIfAbsent(key, first -> errors(topic, calls));
        Map<String, Object> methods = new LinkedHashMap<>(topic.classics());
        methods.keySet().retainAll(known.keySet());
        methods.values().removeIf(method -> !answers(method, timing));
        Map<String, MedianInterval> ratios =
                ratios(methods, reference, timing, warm.add(key) ? FIRST_ROUNDS : 0);
        List<SpeedFigures.MethodSpeed> beside = new ArrayList<>();
        for (String name : methods.keySet())
            beside.add(new SpeedFigures.MethodSpeed(name, ratios.get(name), known.get(name)));
        return beside;
    }

    /** The errors by name, without those that refuse a call. */
    private static Map<String, Double> errors(TopicGrading topic, List<GradedCall> calls) {
        Map<String, Double> errors = new HashMap<>();
        topic.classics()
                .forEach(
                        (name, method) -> {
                            try {
                                errors.put(name, error(method, calls));
                            } catch (IllegalArgumentException refused) {
                                errors.remove(name);
                            }
                        });
        return errors;
    }

    private static double error(Object method, List<GradedCall> calls) {
        double worst = 0;
        for (GradedCall call : calls) {
            OptionalDouble error;
            try {
                error = call.error(call.recorded(method, call.caps().items()));
            } catch (LimitReached endless) {
                error = OptionalDouble.of(Double.POSITIVE_INFINITY);
            }
            worst = Math.max(worst, error.orElse(0));
        }
        return worst;
    }

    private static boolean answers(Object method, TimingInputs timing) {
        try {
            return timing.spent(0, method) > 0;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    /**
     * How many times the reference's time each method takes, by name: the median of the ratios in
     * the same rounds.
     *
     * @param uncounted passes of each before the ones that count
     */
    private static Map<String, MedianInterval> ratios(
            Map<String, Object> methods, Object reference, TimingInputs timing, int uncounted) {
        List<Object> all = new ArrayList<>(methods.values());
        all.add(reference);
        for (int round = 0; round < uncounted; round++) all.forEach(method -> pass(method, timing));
        long start = System.nanoTime();
        var plan = new RoundPlan(ROUNDS, ROUNDS, Duration.ZERO, SEED);
        var rounds = new Rounds(all.size(), plan, System::nanoTime);
        int made = 0;
        while (rounds.more()) {
            for (int one : rounds.order()) rounds.add(one, pass(all.get(one), timing));
            made++;
            if (made >= LEAST_ROUNDS && System.nanoTime() - start > BUDGET_NANOS) break;
        }
        Samples ours = rounds.samples(all.size() - 1);
        Map<String, MedianInterval> ratios = new HashMap<>();
        int number = 0;
        for (String name : methods.keySet())
            ratios.put(name, rounds.samples(number++).over(ours).interval());
        return ratios;
    }

    /** Processor time counts: a busy machine gives a thread its turn later, not slower. */
    private static double pass(Object method, TimingInputs timing) {
        long looked = System.nanoTime();
        long before = THREADS.getCurrentThreadCpuTime();
        long used = 0;
        long items = 0;
        for (int input = 0; input < timing.inputs() && used < PASS_NANOS; input++) {
            items += timing.spent(input, method);
            // asking for the processor time takes as long as some methods do
            if (System.nanoTime() - looked < PASS_NANOS) continue;
            looked = System.nanoTime();
            used = THREADS.getCurrentThreadCpuTime() - before;
        }
        used = THREADS.getCurrentThreadCpuTime() - before;
        return Math.max(1, used) / (double) Math.max(1, items);
    }
}
