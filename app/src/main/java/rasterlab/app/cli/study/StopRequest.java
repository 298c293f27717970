package rasterlab.app.cli.study;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * The wish of whoever waits for a long command that it ends now with what it has: Ctrl-C, or the
 * system's word to stop. The program ends once the command has, or after {@value #LONGEST} seconds.
 */
final class StopRequest implements AutoCloseable {
    private static final long LONGEST = 20;

    private final CountDownLatch done = new CountDownLatch(1);
    private final Thread hook = new Thread(this::make, "stop request");
    private volatile boolean made;

    StopRequest() {
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** Makes the request and waits for the command to end. */
    void make() {
        made = true;
        try {
            done.await(LONGEST, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    boolean isMade() {
        return made;
    }

    /** Says that the command has ended. */
    @Override
    public void close() {
        done.countDown();
        if (made) return;
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException stopping) {
            made = true;
        }
    }
}
