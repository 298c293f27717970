package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.management.ManagementFactory;
import rasterlab.engine.lanes.Lanes;

/** Counts what the threads of a pipeline allocate; one pipeline at a time. */
public final class FrameBytes {
    private static final int ROUNDS = 3;

    /** The Vector API allocates until the compiler has done with it, which may take a while. */
    private static final int VECTOR_ROUNDS = 40;

    private FrameBytes() {}

    /** Fails where frames allocate once thirty of them, or with the Vector API more, are drawn. */
    public static void assertNoneInLaterFrames(Lanes lanes, Runnable frame) {
        int rounds = lanes == Lanes.ONE ? ROUNDS : VECTOR_ROUNDS;
        for (int k = 0; k < 30; k++) frame.run();
        long[] team = team();
        long least = Long.MAX_VALUE;
        // The counter and the first calls of the test itself allocate; frames must not.
        for (int round = 0; round < rounds && least != 0; round++) {
            long before = allocated(team);
            long counting = allocated(team) - before;
            before = allocated(team);
            for (int k = 0; k < 20; k++) frame.run();
            long bytes = allocated(team) - before - counting;
            if (bytes >= 0) least = Math.min(least, bytes);
        }
        assertEquals(0, least, "bytes in 20 frames");
    }

    private static long[] team() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(
                        thread ->
                                thread == Thread.currentThread()
                                        || thread.getName().startsWith("rasterlab-pipeline"))
                .mapToLong(Thread::getId)
                .toArray();
    }

    private static long allocated(long[] threads) {
        var counter = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        long sum = 0;
        for (long thread : threads) sum += counter.getThreadAllocatedBytes(thread);
        return sum;
    }
}
