package rasterlab.exercises.runner;

import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import rasterlab.exercises.TopicGrading.GradedCall;
import rasterlab.exercises.marking.TriedCall;
import rasterlab.exercises.score.Answer;
import rasterlab.exercises.score.Cause;

/**
 * Looks for the smallest input that goes wrong as a call of one case did: it breaks the property
 * too and is explained by the same mistakes, so that it is worth the same. It asks for no more than
 * {@value #MOST_CALLS} inputs and half a second of processor time in each case, and of calls that
 * go wrong alike for the first alone.
 */
final class Shrinking {
    static final int MOST_CALLS = 200;
    static final Duration MOST_TIME = Duration.ofMillis(500);

    /**
     * The most processor time for what is worked out here for one case, where right answers take
     * long. Time that passes while others have the processor does not count: a busy machine finds
     * the same input.
     */
    private static final Duration MOST_HERE = Duration.ofSeconds(2);

    private final Asking student;
    private final Set<List<List<String>>> seen = new HashSet<>();
    private int left = MOST_CALLS;

    /** Asks a student's method for more than counts. */
    interface Asking {
        /** The result of a batch; empty where the method was stopped: then it is asked no more. */
        Optional<TriedCall> aside(GradedCall call) throws InterruptedException;

        /** Processor time that was spent so. */
        Duration spentAside();
    }

    private final Duration before;
    private final long begun = ownNanos();

    Shrinking(Asking student) {
        this.student = student;
        this.before = student.spentAside();
    }

    /** The call on the smallest input that was found; itself where nothing is to be shown. */
    TriedCall of(TriedCall tried) throws InterruptedException {
        if (!breaks(tried) || !seen.add(codes(tried))) return tried;
        TriedCall smallest = tried;
        Optional<TriedCall> next = smaller(tried);
        while (next.isPresent()) {
            smallest = next.get();
            next = smaller(smallest);
        }
        return smallest;
    }

    private Optional<TriedCall> smaller(TriedCall tried) throws InterruptedException {
        Iterator<GradedCall> all = tried.call().smaller().iterator();
        while (isTimeLeft() && all.hasNext()) {
            left--;
            Optional<TriedCall> one = student.aside(all.next());
            if (one.isEmpty()) left = 0;
            else if (breaks(one.get()) && codes(one.get()).equals(codes(tried))) return one;
        }
        return Optional.empty();
    }

    private boolean isTimeLeft() {
        return left > 0
                && student.spentAside().minus(before).compareTo(MOST_TIME) < 0
                && ownNanos() - begun < MOST_HERE.toNanos();
    }

    private static long ownNanos() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }

    private static boolean breaks(TriedCall tried) {
        Optional<Answer> answer = tried.answer();
        return !tried.finding().right()
                && answer.isPresent()
                && tried.call().breaksProperty(answer.get());
    }

    private static List<List<String>> codes(TriedCall tried) {
        return tried.finding().explanations().stream().map(Cause::codes).toList();
    }
}
