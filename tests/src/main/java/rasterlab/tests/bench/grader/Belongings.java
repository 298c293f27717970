package rasterlab.tests.bench.grader;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;

/**
 * Keeps what a benchmark starts and makes on this machine: processes, mounts, folders. The last is
 * ended first, also where this process is told to end before.
 */
final class Belongings implements AutoCloseable {
    private final Deque<AutoCloseable> all = new ArrayDeque<>();
    private boolean closed;

    Belongings() {
        Runtime.getRuntime().addShutdownHook(new Thread(this::close));
    }

    /** Starts or makes something. */
    interface BelongingStart<T> {
        T begin() throws IOException;
    }

    /**
     * Takes in what is started by that, and returns it.
     *
     * @throws IllegalStateException where all has been ended, and nothing is started any more
     */
    synchronized <T extends AutoCloseable> T add(BelongingStart<T> one) throws IOException {
        if (closed)
            throw new IllegalStateException("nothing is started any more: the end has begun");
        T begun = one.begin();
        all.push(begun);
        return begun;
    }

    /**
     * Ends all, whatever comes of the others.
     *
     * @throws IllegalStateException where some did not end
     */
    @Override
    public synchronized void close() {
        closed = true;
        IllegalStateException failed = null;
        while (!all.isEmpty()) {
            AutoCloseable one = all.pop();
            try {
                one.close();
            } catch (Exception left) {
                if (failed == null) failed = new IllegalStateException("left behind: " + one);
                failed.addSuppressed(left);
            }
        }
        if (failed != null) throw failed;
    }
}
