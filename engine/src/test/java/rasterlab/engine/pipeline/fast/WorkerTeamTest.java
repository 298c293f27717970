package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CyclicBarrier;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicIntegerArray;
import java.util.function.BooleanSupplier;
import java.util.function.IntConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(value = 5, unit = TimeUnit.MINUTES, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class WorkerTeamTest {
    private static final int ROUNDS = 2000;

    @ParameterizedTest(name = "{0} threads, {1} items: an item is left out, or done twice")
    @CsvSource({"1,0", "1,7", "2,1", "2,100", "7,0", "7,3", "7,1000", "16,23"})
    void eachItemIsDoneOnce(int threads, int items) {
        var done = new AtomicIntegerArray(items);
        try (var team = new WorkerTeam(threads)) {
            for (int round = 1; round <= ROUNDS; round++) {
                team.run((item, worker) -> done.incrementAndGet(item), items);
                for (int item = 0; item < items; item++)
                    assertEquals(round, done.get(item), "item " + item);
            }
        }
    }

    @Test
    void noTwoThreadsHaveOneNumberAtOneTime() {
        int threads = 7;
        var inUse = new AtomicIntegerArray(threads);
        var twice = new AtomicInteger();
        try (var team = new WorkerTeam(threads)) {
            for (int round = 0; round < ROUNDS; round++)
                team.run(
                        (item, worker) -> {
                            if (inUse.getAndSet(worker, 1) != 0) twice.incrementAndGet();
                            Thread.onSpinWait();
                            inUse.set(worker, 0);
                        },
                        50);
        }
        assertEquals(0, twice.get(), "items begun while their worker had another");
    }

    @ParameterizedTest(name = "{0} threads: one that sleeps is not woken for an item of its own")
    @ValueSource(ints = {2, 3, 4, 8, 13, 32})
    void allThatSleepAreWokenWhereThereIsWorkForAll(int threads) {
        try (var team = new WorkerTeam(threads)) {
            for (int round = 0; round < 3; round++) {
                awaitSleep(team);
                allAtOnce(team);
            }
        }
    }

    @Test
    void whoWaitsForLongItemsIsWokenByTheLastOne() {
        var caller = Thread.currentThread();
        try (var team = new WorkerTeam(2)) {
            for (int round = 0; round < 20; round++) {
                var done = new AtomicInteger();
                onEach(
                        team,
                        worker -> {
                            if (worker > 0) awaitState(caller, Thread.State.WAITING);
                            done.incrementAndGet();
                        });
                assertEquals(2, done.get());
            }
        }
    }

    @Test
    void whatAnItemThrowsComesOutWhenNobodyWorksAnyMore() {
        var caller = Thread.currentThread();
        var thrown = new IllegalStateException("broken");
        try (var team = new WorkerTeam(2)) {
            for (int round = 0; round < 20; round++) {
                var ended = new AtomicInteger();
                IntConsumer item =
                        worker -> {
                            if (worker == 0) throw thrown;
                            awaitState(caller, Thread.State.WAITING);
                            ended.incrementAndGet();
                        };
                assertSame(
                        thrown,
                        assertThrows(IllegalStateException.class, () -> onEach(team, item)));
                assertEquals(1, ended.get());
            }
        }
    }

    @Test
    void whatIsLeftOutAfterAFailureIsNotDoneInTheNextTask() {
        int items = 1000;
        try (var team = new WorkerTeam(4)) {
            for (int round = 0; round < ROUNDS; round++) {
                assertThrows(
                        IllegalStateException.class,
                        () ->
                                team.run(
                                        (item, worker) -> {
                                            if (item == 5) throw new IllegalStateException();
                                        },
                                        items));
                var done = new AtomicInteger();
                team.run((item, worker) -> done.incrementAndGet(), items);
                assertEquals(items, done.get());
            }
        }
    }

    @Test
    void interruptionIsKeptAndLeavesNothingOut() {
        var caller = Thread.currentThread();
        var done = new AtomicInteger();
        try (var team = new WorkerTeam(2)) {
            onEach(
                    team,
                    worker -> {
                        if (worker > 0) {
                            awaitState(caller, Thread.State.WAITING);
                            caller.interrupt();
                            awaitTrue("the interruption is taken", () -> !caller.isInterrupted());
                            awaitState(caller, Thread.State.WAITING);
                        }
                        done.incrementAndGet();
                    });
            assertEquals(2, done.get());
            assertTrue(Thread.interrupted());
        }
    }

    @Test
    void interruptedWorkersGoOnWorking() {
        try (var team = new WorkerTeam(4)) {
            awaitSleep(team);
            workers(team).forEach(Thread::interrupt);
            allAtOnce(team);
            awaitSleep(team);
            allAtOnce(team);
        }
    }

    @Test
    void closedTeamHasNoThreadsAndRefusesWork() {
        var team = new WorkerTeam(5);
        awaitSleep(team);
        allAtOnce(team);
        awaitSleep(team);
        assertEquals(4, workers(team).size());
        team.close();
        for (Thread thread : workers(team)) awaitState(thread, Thread.State.TERMINATED);
        assertThrows(IllegalStateException.class, () -> team.run((item, worker) -> {}, 1));
    }

    @Test
    void whatNoTaskMayThrowComesOutAsACause() {
        var thrown = new IOException("checked");
        IntConsumer item =
                worker -> {
                    if (worker > 0) throwUnchecked(thrown);
                };
        try (var team = new WorkerTeam(2)) {
            var caught = assertThrows(IllegalStateException.class, () -> onEach(team, item));
            assertSame(thrown, caught.getCause());
        }
    }

    @SuppressWarnings("unchecked")
    private static <T extends Throwable> void throwUnchecked(Throwable thrown) throws T {
        throw (T) thrown;
    }

    @ParameterizedTest(name = "{0} threads are not refused")
    @ValueSource(ints = {-1, 0, 257})
    void refusesNumbersOfThreadsByTheirValue(int threads) {
        var refused = assertThrows(IllegalArgumentException.class, () -> new WorkerTeam(threads));
        assertEquals("threads must be from 1 to 256, got " + threads, refused.getMessage());
    }

    /** Each thread has one item, and has begun it before any goes on. */
    private static void onEach(WorkerTeam team, IntConsumer item) {
        var all = new CyclicBarrier(team.threads.length);
        team.run(
                (number, worker) -> {
                    await(all);
                    item.accept(worker);
                },
                team.threads.length);
    }

    private static void allAtOnce(WorkerTeam team) {
        var workers = new AtomicIntegerArray(team.threads.length);
        onEach(team, worker -> workers.set(worker, 1));
        for (int k = 0; k < team.threads.length; k++)
            assertEquals(1, workers.get(k), "worker " + k);
    }

    private static void await(CyclicBarrier barrier) {
        try {
            barrier.await(2, TimeUnit.MINUTES);
        } catch (InterruptedException | BrokenBarrierException | TimeoutException e) {
            throw new AssertionError("not all threads came", e);
        }
    }

    private static List<Thread> workers(WorkerTeam team) {
        return Arrays.asList(team.threads).subList(1, team.threads.length);
    }

    private static void awaitSleep(WorkerTeam team) {
        workers(team).forEach(thread -> awaitState(thread, Thread.State.WAITING));
    }

    private static void awaitState(Thread thread, Thread.State state) {
        awaitTrue(thread.getName() + " is " + state, () -> thread.getState() == state);
    }

    private static void awaitTrue(String what, BooleanSupplier condition) {
        long start = System.nanoTime();
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() - start > TimeUnit.MINUTES.toNanos(2))
                throw new AssertionError("not within 2 min: " + what);
            Thread.onSpinWait();
        }
    }
}
