package rasterlab.engine.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class GuardTest {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    @ParameterizedTest(name = "running {0}, {1} ms of 100 used after {2} ms: {3} ms more")
    @CsvSource({
        "true, 40, 100, 60",
        "true, 0, 100, 100",
        "true, 98, 2000, 2",
        "true, 0, 9999, 100",
        "true, 0, 10000, 0",
        "true, 100, 100, 0",
        "true, 130, 200, 0",
        "false, 40, 100, 0",
    })
    void onlyWhatRunsIsWaitedForUntilItHasHadItsTime(
            boolean runs, long used, long passed, long more) {
        var thread = new CpuStarvation(runs, Duration.ofMillis(used));
        assertEquals(
                Duration.ofMillis(more),
                thread.more(Duration.ofMillis(100), Duration.ofMillis(passed)));
    }

    @Test
    void theLastNanosecondIsNotWaitedForInVain() {
        Duration limit = Duration.ofMillis(100);
        assertEquals(
                Duration.ofMillis(1),
                new CpuStarvation(true, limit.minusNanos(1)).more(limit, limit));
    }

    @Test
    void loopWithoutEndIsGivenUpAfterItsProcessorTime() {
        var stop = new CountDownLatch(1);
        Duration limit = Duration.ofMillis(60);
        var used = new long[1];
        var outcome =
                Guard.call(
                        "loop",
                        () -> {
                            while (stop.getCount() > 0) used[0] = THREADS.getCurrentThreadCpuTime();
                            return used;
                        },
                        limit);
        stop.countDown();
        assertEquals(new Guard.TimedOut<>(limit), outcome);
        assertTrue(used[0] >= limit.toNanos() * 0.9, used[0] + " ns");
    }

    @Test
    void whatTakesLessProcessorTimeThanItsLimitReturnsHoweverBusyTheMachineIs() {
        var stop = new CountDownLatch(1);
        int processors = Runtime.getRuntime().availableProcessors();
        try {
            for (int i = 0; i < 4 * processors; i++) busy(stop).start();
            var outcome =
                    Guard.call("work", () -> spend(Duration.ofMillis(80)), Duration.ofMillis(120));
            assertEquals(new Guard.Returned<>("spent"), outcome);
        } finally {
            stop.countDown();
        }
    }

    private static Thread busy(CountDownLatch stop) {
        var thread =
                new Thread(
                        () -> {
                            while (stop.getCount() > 0) Thread.onSpinWait();
                        });
        thread.setDaemon(true);
        return thread;
    }

    private static String spend(Duration processor) {
        while (THREADS.getCurrentThreadCpuTime() < processor.toNanos()) Thread.onSpinWait();
        return "spent";
    }
}
