package rasterlab.app.canvas.work;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(300)
class BackgroundTest {
    private final BlockingQueue<Runnable> events = new LinkedBlockingQueue<>();
    private final BlockingQueue<Throwable> failures = new LinkedBlockingQueue<>();
    private final List<String> heard = new ArrayList<>();

    private Background background() {
        return new Background("work", events::add, failures::add);
    }

    private void begin(Background background, Background.Task task) {
        background.begin(task, () -> heard.add("end"), failure -> heard.add(failure.getMessage()));
    }

    @Test
    void newsAndResultComeInOrder() throws Exception {
        try (var background = background()) {
            begin(
                    background,
                    tell -> {
                        tell.accept(() -> heard.add("news"));
                        return () -> heard.add("result");
                    });
            events.take().run();
            events.take().run();
        }
        assertEquals(List.of("news", "end", "result"), heard);
    }

    @Test
    void workThatIsGivenUpIsNotHeardOfEvenIfItGoesOn() throws Exception {
        var begun = new CountDownLatch(1);
        try (var background = background()) {
            begin(
                    background,
                    tell -> {
                        tell.accept(() -> heard.add("news"));
                        begun.countDown();
                        awaitInterruption();
                        tell.accept(() -> heard.add("late news"));
                        return () -> heard.add("late result");
                    });
            begun.await();
            background.cancel();
            begin(background, tell -> () -> heard.add("next"));
            while (!heard.contains("next")) events.take().run();
        }
        assertEquals(List.of("end", "next"), heard);
    }

    private static void awaitInterruption() {
        try {
            new CountDownLatch(1).await();
        } catch (InterruptedException expected) {
            return;
        }
    }

    @Test
    void failureOfInputIsToldWhereTheWorkWasBegun() throws Exception {
        try (var background = background()) {
            begin(
                    background,
                    tell -> {
                        throw new IOException("no server");
                    });
            events.take().run();
        }
        assertEquals(List.of("end", "no server"), heard);
        assertEquals(0, failures.size());
    }

    @Test
    void mistakeOfOursIsReportedAndTheWorkEnds() throws Exception {
        try (var background = background()) {
            begin(
                    background,
                    tell -> {
                        throw new IllegalStateException("ours");
                    });
            events.take().run();
        }
        assertEquals(List.of("end"), heard);
        assertEquals("ours", failures.take().getMessage());
    }
}
