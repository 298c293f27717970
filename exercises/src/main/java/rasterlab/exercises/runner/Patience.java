package rasterlab.exercises.runner;

import java.lang.management.ManagementFactory;
import java.lang.management.OperatingSystemMXBean;
import java.time.Duration;
import java.util.function.DoubleSupplier;
import rasterlab.exercises.runner.process.TimeLimit;

/**
 * How much wall time a child gets for its processor time. On a busy machine a method waits for its
 * turn, which is no fault of its own; only one that sleeps or is locked waits this long.
 */
final class Patience {
    /** The wall time for a unit of processor time on an idle machine. */
    static final int MARGIN = 3;

    /** No machine is taken to be busier: one that waits for ever must end some time. */
    static final int MOST = 100;

    private final DoubleSupplier load;

    /**
     * @param load processes that want to run, for each processor; negative where it is not known
     */
    Patience(DoubleSupplier load) {
        this.load = load;
    }

    static Patience ofThisMachine() {
        OperatingSystemMXBean system = ManagementFactory.getOperatingSystemMXBean();
        return new Patience(() -> system.getSystemLoadAverage() / system.getAvailableProcessors());
    }

    /** Whether more processes want to run than can, so that wall time tells little. */
    boolean isBusy() {
        return load.getAsDouble() > 1;
    }

    TimeLimit limit(Duration processor) {
        double times = MARGIN * (1 + Math.max(0, load.getAsDouble()));
        long nanos = (long) (processor.toNanos() * Math.min(MOST, times));
        return new TimeLimit(processor, Duration.ofNanos(nanos));
    }
}
