package rasterlab.app.shell.labs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Queue;
import org.junit.jupiter.api.Test;

class HeldEventsTest {
    private final Queue<Runnable> thread = new ArrayDeque<>();
    private final List<String> done = new ArrayList<>();
    private final HeldEvents events = new HeldEvents(thread::add);

    private void runThread() {
        while (!thread.isEmpty()) thread.remove().run();
    }

    @Test
    void workWaitsUntilItIsLetGoAndThenGoesOnInOrder() {
        events.execute(() -> done.add("first"));
        events.execute(() -> events.execute(() -> done.add("third")));
        runThread();
        assertEquals(List.of(), done);
        events.letGo();
        events.execute(() -> done.add("second"));
        runThread();
        assertEquals(List.of("first", "second", "third"), done);
    }

    @Test
    void letGoTwiceRunsNothingTwice() {
        events.execute(() -> done.add("once"));
        events.letGo();
        events.letGo();
        runThread();
        assertEquals(List.of("once"), done);
    }
}
