package rasterlab.engine.study;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;

/**
 * Tells a thread that lacks a processor from one that wastes its time.
 *
 * @param runs whether it wants to run, rather than to sleep or to wait for a lock
 * @param used processor time that it has had
 */
record CpuStarvation(boolean runs, Duration used) {
    /** No machine is taken to be busier: what hangs in the system must end some time. */
    static final int MOST = 100;

    private static final Duration LEAST_WAIT = Duration.ofMillis(1);

    static CpuStarvation of(Thread thread) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        boolean runs = thread.getState() == Thread.State.RUNNABLE;
        if (!threads.isThreadCpuTimeSupported() || !threads.isThreadCpuTimeEnabled())
            return new CpuStarvation(false, Duration.ZERO);
        // It is negative for a thread that has ended meanwhile.
        long nanos = threads.getThreadCpuTime(thread.getId());
        return new CpuStarvation(runs, Duration.ofNanos(Math.max(0, nanos)));
    }

    /**
     * How much longer it is waited for; zero where its time is over.
     *
     * @param limit the processor time it may take
     * @param passed wall time since it began
     */
    Duration more(Duration limit, Duration passed) {
        Duration lacking = limit.minus(used);
        if (!runs || lacking.compareTo(Duration.ZERO) <= 0) return Duration.ZERO;
        if (passed.compareTo(limit.multipliedBy(MOST)) >= 0) return Duration.ZERO;
        return lacking.compareTo(LEAST_WAIT) < 0 ? LEAST_WAIT : lacking;
    }
}
