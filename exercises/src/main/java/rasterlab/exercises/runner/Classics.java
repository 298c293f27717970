package rasterlab.exercises.runner;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import rasterlab.engine.study.LimitReached;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.TopicGrading;
import rasterlab.exercises.TopicGrading.Call;
import rasterlab.exercises.TopicGrading.Timing;
import rasterlab.exercises.score.SpeedFigures;

/**
 * Times a topic's right methods against an exercise's reference, in this process, in turns and on
 * the inputs that a student was timed on last; and judges their errors on given calls.
 *
 * <p>Several threads may ask; they take turns, so that none disturbs another's times.
 */
final class Classics {
    /** A method's least of so many passes counts, since all else only adds time. */
    private static final int ROUNDS = 5;

    private static final int LEAST_ROUNDS = 2;

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
    synchronized List<SpeedFigures.Method> beside(
            Exercise exercise,
            TopicGrading topic,
            Timing timing,
            Object reference,
            List<Call> calls) {
        String key = exercise.id() + ' ' + exercise.revision();
        Map<String, Double> known = errors.computeIfAbsent(key, first -> errors(topic, calls));
        Map<String, Object> methods = new LinkedHashMap<>(topic.classics());
        methods.keySet().retainAll(known.keySet());
        methods.values().removeIf(method -> !answers(method, timing));
        Map<String, Double> nanos =
                nanos(methods, reference, timing, warm.add(key) ? FIRST_ROUNDS : 0);
        double ours = nanos.get("");
        List<SpeedFigures.Method> beside = new ArrayList<>();
        for (String name : methods.keySet())
            beside.add(new SpeedFigures.Method(name, nanos.get(name) / ours, known.get(name)));
        return beside;
    }

    /** The errors by name, without those that refuse a call. */
    private static Map<String, Double> errors(TopicGrading topic, List<Call> calls) {
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

    private static double error(Object method, List<Call> calls) {
        double worst = 0;
        for (Call call : calls) {
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

    private static boolean answers(Object method, Timing timing) {
        try {
            return timing.spent(0, method) > 0;
        } catch (IllegalArgumentException refused) {
            return false;
        }
    }

    /**
     * Nanoseconds per item by name; those of the reference by "".
     *
     * @param uncounted passes of each before the ones that count
     */
    private static Map<String, Double> nanos(
            Map<String, Object> methods, Object reference, Timing timing, int uncounted) {
        Map<String, Object> all = new LinkedHashMap<>();
        all.put("", reference);
        all.putAll(methods);
        for (int round = 0; round < uncounted; round++)
            all.values().forEach(method -> pass(method, timing));
        Map<String, Double> least = new HashMap<>();
        long start = System.nanoTime();
        for (int round = 0; round < ROUNDS; round++) {
            all.forEach((name, method) -> least.merge(name, pass(method, timing), Math::min));
            boolean late = System.nanoTime() - start > BUDGET_NANOS;
            if (late && round + 1 >= LEAST_ROUNDS) break;
        }
        return least;
    }

    /** Processor time counts: a busy machine gives a thread its turn later, not slower. */
    private static double pass(Object method, Timing timing) {
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
