package rasterlab.app.canvas.work;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.ref.WeakReference;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(300)
class LatestOnlyTest {
    private final BlockingQueue<Integer> begun = new LinkedBlockingQueue<>();
    private final Semaphore mayEnd = new Semaphore(0);
    private final List<Integer> answers = new CopyOnWriteArrayList<>();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final LatestOnly<Integer, Integer> latest =
            new LatestOnly<>("test", this::work, (q, a) -> answers.add(a), failures::add);

    /** Ends when the test lets it; stops when it is cancelled by then; fails on 13. */
    private Integer work(Integer question, BooleanSupplier cancelled) {
        begun.add(question);
        mayEnd.acquireUninterruptibly();
        if (question == 13) throw new IllegalStateException("unlucky");
        if (cancelled.getAsBoolean()) throw new CancellationException();
        return question;
    }

    @AfterEach
    void close() {
        latest.close();
        mayEnd.release(100);
    }

    @Test
    void dropsEveryWaitingQuestionButTheNewest() throws InterruptedException {
        latest.ask(1);
        assertEquals(1, begun.take());
        for (int question = 2; question <= 50; question++) latest.ask(question);
        mayEnd.release(100);
        latest.settle();
        assertEquals(List.of(50), answers);
        assertEquals(List.of(50), List.copyOf(begun));
    }

    @Test
    void answersAtLeastEverySecondQuestionOfAnEndlessDrag() throws InterruptedException {
        for (int question = 1; question <= 9; question++) {
            latest.ask(question);
            if (question > 1) mayEnd.release();
            assertEquals(question, begun.take());
        }
        mayEnd.release(100);
        latest.settle();
        assertTrue(answers.size() >= 4, "answered " + answers);
        assertEquals(9, answers.get(answers.size() - 1));
    }

    @Test
    void cancelledQuestionIsNeverAnswered() throws InterruptedException {
        latest.ask(1);
        begun.take();
        latest.cancel();
        mayEnd.release();
        latest.settle();
        assertEquals(List.of(), answers);
        assertEquals(List.of(), failures);
    }

    @Test
    void failureIsToldAndTheNextQuestionIsAnswered() throws InterruptedException {
        mayEnd.release(100);
        latest.ask(13);
        latest.settle();
        assertInstanceOf(IllegalStateException.class, failures.get(0));
        latest.ask(14);
        latest.settle();
        assertEquals(List.of(14), answers);
    }

    /** Threads of a parallel loop outlive the one that threw: they ask again at their next row. */
    @Test
    void rowsLeftRunningByAFailureAreNotRevivedByTheNextQuestion() throws InterruptedException {
        var signs = new CopyOnWriteArrayList<BooleanSupplier>();
        var rows =
                new LatestOnly<Integer, Integer>(
                        "rows",
                        (question, cancelled) -> {
                            signs.add(cancelled);
                            if (question == 13) throw new IllegalStateException("unlucky");
                            begun.add(question);
                            mayEnd.acquireUninterruptibly();
                            return question;
                        },
                        (q, a) -> answers.add(a),
                        failures::add);
        rows.ask(13);
        rows.settle();
        rows.ask(14);
        begun.take();
        assertTrue(signs.get(0).getAsBoolean(), "a row of 13 goes on while 14 is answered");
        assertFalse(signs.get(1).getAsBoolean());
        mayEnd.release();
        rows.settle();
        rows.close();
        assertEquals(List.of(14), answers);
    }

    @Test
    void isClosedAtOnceAndGivesBackWhatTheWorkUsesOnlyAfterTheWork() throws InterruptedException {
        var givenBack = new LinkedBlockingQueue<String>();
        latest.ask(1);
        begun.take();
        latest.close(() -> givenBack.add(Thread.currentThread().getName()));
        assertTrue(givenBack.isEmpty());
        mayEnd.release();
        assertEquals("test", givenBack.take());
    }

    @Test
    @DisplayName("the last question is kept, and all it holds, until there is another")
    void answeredQuestionIsLetGo() throws InterruptedException {
        try (var words =
                new LatestOnly<byte[], Integer>(
                        "let go", (q, cancelled) -> q.length, (q, a) -> {}, failures::add)) {
            WeakReference<byte[]> question = asked(words);
            words.settle();
            while (question.get() != null && !Thread.currentThread().isInterrupted()) System.gc();
            assertNull(question.get());
        }
    }

    private static WeakReference<byte[]> asked(LatestOnly<byte[], Integer> words) {
        var question = new byte[1000];
        words.ask(question);
        return new WeakReference<>(question);
    }
}
