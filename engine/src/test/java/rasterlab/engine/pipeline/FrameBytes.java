package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.management.ManagementFactory;

/** Counts what the threads of a pipeline allocate; one pipeline at a time. */
public final class FrameBytes {
    private FrameBytes() {}

    /** Fails where frames allocate once thirty of them are drawn. */
    public static void assertNoneInLaterFrames(Runnable frame) {
        for (int k = 0; k < 30; k++) frame.run();
        long[] team = team();
        long least = Long.MAX_VALUE;
        // The counter and the first calls of the test itself allocate; frames must not.
        for (int round = 0; round < 3; round++) {
            long before = allocated(team);
            long counting = allocated(team) - before;
            before = allocated(team);
            for (int k = 0; k < 20; k++) frame.run();
            least = Math.min(least, allocated(team) - before - counting);
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
