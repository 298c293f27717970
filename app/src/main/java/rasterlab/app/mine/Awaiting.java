package rasterlab.app.mine;

import java.time.Duration;
import java.util.function.LongSupplier;

/**
 * How long a program's answers have been awaited. Calls that follow each other closely, as those
 * for one picture do, are one wait. On any thread.
 */
final class Awaiting {
    /** A pause that is shorter ends no wait. */
    private static final long PAUSE = Duration.ofMillis(50).toNanos();

    private final LongSupplier nanos;
    private int calls;
    private boolean any;
    private long since;
    private long last;

    /**
     * @param nanos the time, as {@link System#nanoTime}
     */
    Awaiting(LongSupplier nanos) {
        this.nanos = nanos;
    }

    /** A call begins. */
    synchronized void begin() {
        long now = nanos.getAsLong();
        if (!going(now)) since = now;
        calls++;
        any = true;
    }

    /** A call has ended. */
    synchronized void end() {
        calls--;
        last = nanos.getAsLong();
    }

    /** Whether there is a wait which has lasted so long. */
    synchronized boolean lasts(Duration least) {
        long now = nanos.getAsLong();
        return going(now) && now - since >= least.toNanos();
    }

    private boolean going(long now) {
        return calls > 0 || any && now - last < PAUSE;
    }
}
