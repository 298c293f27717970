package rasterlab.engine.study;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;

/**
 * Adds up what a guarded thread has spent: processor time, and time in which it wanted none, asleep
 * or waiting for a lock. Time in which it wanted to run and another had the processor is not its
 * own.
 *
 * <p>Whether it wants to run is known for the moments of {@link #more} alone, so a thread that
 * waits just then is charged with the time since the last look, and not with its whole limit.
 */
final class SpentTime {
    /** No machine is taken to be busier: what hangs in the system must end some time. */
    static final int MOST = 100;

    /** Looks within a limit. */
    static final int LOOKS = 20;

    /** Nanoseconds between two looks, at least. */
    static final long LEAST_NANOS = 1_000_000;

    private final Duration limit;
    private Duration passed = Duration.ZERO;
    private Duration used = Duration.ZERO;
    private Duration idle = Duration.ZERO;

    /**
     * @param limit of what it may spend
     */
    SpentTime(Duration limit) {
        this.limit = limit;
    }

    /**
     * A thread as it is seen at one moment.
     *
     * @param runs whether it wants to run, rather than to sleep or to wait for a lock
     * @param used processor time that it has had
     */
    record ThreadLook(boolean runs, Duration used) {
        static ThreadLook at(Thread thread) {
            ThreadMXBean threads = ManagementFactory.getThreadMXBean();
            boolean runs = thread.getState() == Thread.State.RUNNABLE;
            if (!threads.isThreadCpuTimeSupported() || !threads.isThreadCpuTimeEnabled())
                return new ThreadLook(false, Duration.ZERO);
            // It is negative for a thread that has ended meanwhile.
            long nanos = threads.getThreadCpuTime(thread.getId());
            return new ThreadLook(runs, Duration.ofNanos(Math.max(0, nanos)));
        }
    }

    /**
     * How long to wait until the next look; zero where its time is over.
     *
     * @param wall time since the thread began
     */
    Duration more(ThreadLook seen, Duration wall) {
        Duration since = wall.minus(passed);
        Duration ran = seen.used().minus(used);
        if (!seen.runs() && since.compareTo(ran) > 0) idle = idle.plus(since.minus(ran));
        passed = wall;
        used = seen.used();
        Duration left = limit.minus(used).minus(idle);
        if (left.compareTo(Duration.ZERO) <= 0) return Duration.ZERO;
        if (passed.compareTo(limit.multipliedBy(MOST)) >= 0) return Duration.ZERO;
        return atMostOneLook(left);
    }

    private Duration atMostOneLook(Duration left) {
        Duration look = limit.dividedBy(LOOKS);
        Duration wait = left.compareTo(look) < 0 ? left : look;
        return Duration.ofNanos(Math.max(LEAST_NANOS, wait.toNanos()));
    }
}
