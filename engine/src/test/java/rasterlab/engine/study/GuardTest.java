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
import rasterlab.engine.study.SpentTime.ThreadLook;

class GuardTest {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private static final Duration LIMIT = Duration.ofMillis(100);

    @ParameterizedTest(name = "{0} ms of 100 used after {1} ms: looked at again after {2} ms")
    @CsvSource({
        "40, 100, 5",
        "0, 100, 5",
        "98, 2000, 2",
        "0, 9999, 5",
        "0, 10000, 0",
        "100, 100, 0",
        "130, 200, 0",
    })
    void whatRunsIsWaitedForUntilItHasHadItsTime(long used, long passed, long more) {
        assertEquals(
                ms(more), new SpentTime(LIMIT).more(new ThreadLook(true, ms(used)), ms(passed)));
    }

    @Test
    void theLastNanosecondIsNotWaitedForInVain() {
        var runs = new ThreadLook(true, LIMIT.minusNanos(1));
        assertEquals(ms(1), new SpentTime(LIMIT).more(runs, LIMIT));
    }

    @Test
    void sleepCountsAsTimeSpentFromOneLookToTheNext() {
        var spent = new SpentTime(LIMIT);
        assertEquals(ms(5), spent.more(new ThreadLook(false, ms(0)), ms(60)));
        assertEquals(ms(5), spent.more(new ThreadLook(true, ms(20)), ms(300)));
        assertEquals(ms(4), spent.more(new ThreadLook(false, ms(30)), ms(316)));
        assertEquals(ms(0), spent.more(new ThreadLook(false, ms(30)), ms(320)));
    }

    @Test
    void aLockHeldAtOneMomentOfABusyMachineDoesNotTakeAllTheTime() {
        var spent = new SpentTime(LIMIT);
        assertEquals(ms(5), spent.more(new ThreadLook(true, ms(10)), ms(1000)));
        assertEquals(ms(5), spent.more(new ThreadLook(false, ms(10)), ms(1005)));
        assertEquals(ms(5), spent.more(new ThreadLook(true, ms(20)), ms(2000)));
    }

    @Test
    void whatEndsWhileItIsLookedAtHasReturned() {
        var looked = new CountDownLatch(1);
        var outcome =
                Guard.call(
                        "late",
                        () -> {
                            looked.await();
                            return "ended";
                        },
                        ms(1),
                        new Guard.Lookout() {
                            @Override
                            ThreadLook look(Thread thread) {
                                looked.countDown();
                                join(thread);
                                return new ThreadLook(false, LIMIT);
                            }
                        });
        assertEquals(new Guard.Returned<>("ended"), outcome);
    }

    private static void join(Thread thread) {
        try {
            thread.join();
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
    }

    private static Duration ms(long number) {
        return Duration.ofMillis(number);
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
