package rasterlab.app.canvas.work;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Answers the newest question on a thread of its own; older ones are cancelled, none pile up.
 *
 * <p>So that a fast drag still shows pictures, a question is let finish when the one before it was
 * cancelled: at least every second question that was begun is answered. Each question has a sign of
 * its own for being cancelled, and it is set too when the work ends: threads that the work left
 * behind stop, whatever is asked next.
 *
 * @param <Q> an immutable question
 * @param <A> its answer
 */
public final class LatestOnly<Q, A> implements AutoCloseable {
    /** Work that takes longer than a frame. */
    @FunctionalInterface
    public interface LongWork<Q, A> {
        /**
         * @param cancelled asked often; the answer is of no use once it is true
         * @throws CancellationException when it stopped because of {@code cancelled}
         */
        A answer(Q question, BooleanSupplier cancelled);
    }

    private final LongWork<Q, A> work;
    private final BiConsumer<Q, A> answered;
    private final Consumer<Throwable> failed;
    private final Thread worker;

    private Optional<Q> waiting = Optional.empty();
    private boolean busy;
    private boolean closed;
    private Runnable last = () -> {};
    private boolean lastWasCancelled;
    private AtomicBoolean cancelled = new AtomicBoolean();

    /**
     * @param answered told each answer, on the worker's thread
     * @param failed told what the work threw, on the worker's thread
     */
    public LatestOnly(
            String threadName,
            LongWork<Q, A> work,
            BiConsumer<Q, A> answered,
            Consumer<Throwable> failed) {
        this.work = work;
        this.answered = answered;
        this.failed = failed;
        worker = new Thread(this::run, threadName);
        worker.setDaemon(true);
        worker.start();
    }

    /** Puts this question in place of the one that waits, and cancels the one being answered. */
    public synchronized void ask(Q question) {
        waiting = Optional.of(question);
        if (busy && !lastWasCancelled) cancelled.set(true);
        notifyAll();
    }

    /** Drops the question that waits and cancels the one being answered. */
    public synchronized void cancel() {
        waiting = Optional.empty();
        cancelled.set(true);
    }

    /** Waits until every question asked so far is answered or dropped. */
    public synchronized void settle() throws InterruptedException {
        while (busy || waiting.isPresent()) wait();
    }

    @Override
    public void close() {
        close(() -> {});
    }

    /**
     * Ends the thread as soon as its present question is over; nobody waits for that.
     *
     * @param after run at the end of the thread, such as giving back what the work used
     */
    public synchronized void close(Runnable after) {
        last = after;
        closed = true;
        cancel();
        notifyAll();
    }

    private void run() {
        while (answered(next()))
            ; // No variable here: it would keep the last question while the next is waited for.
        try {
            atEnd().run();
        } catch (Throwable e) {
            failed.accept(e);
        }
    }

    /** Whether there was a question. */
    private boolean answered(Optional<Q> question) {
        question.ifPresent(asked -> answer(asked, currentSign()));
        return question.isPresent();
    }

    private synchronized Runnable atEnd() {
        return last;
    }

    private synchronized AtomicBoolean currentSign() {
        return cancelled;
    }

    private void answer(Q question, AtomicBoolean sign) {
        try {
            A answer = work.answer(question, sign::get);
            if (!sign.get()) answered.accept(question, answer);
        } catch (CancellationException e) {
            if (!sign.get()) failed.accept(e);
        } catch (Throwable e) {
            failed.accept(e);
        }
    }

    /** Ends the last question and waits for the next; empty when closed. */
    private synchronized Optional<Q> next() {
        lastWasCancelled = busy && cancelled.getAndSet(true);
        busy = false;
        notifyAll();
        try {
            while (waiting.isEmpty() && !closed) wait();
        } catch (InterruptedException e) {
            closed = true;
        }
        if (closed) {
            waiting = Optional.empty();
            return waiting;
        }
        busy = true;
        cancelled = new AtomicBoolean();
        Optional<Q> question = waiting;
        waiting = Optional.empty();
        return question;
    }
}
